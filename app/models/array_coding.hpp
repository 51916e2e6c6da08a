#pragma once

#include "prelude.hpp"

namespace taut::app {

/// Writes values as they are in memory, for another process of this program.
class ArrayWriter {
 public:
  template <class T> void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }

  template <class T> void put_list(const T& list) {
    using Item = typename T::value_type;
    static_assert(std::is_trivially_copyable_v<Item>);
    put(static_cast<std::uint64_t>(list.size()));
    bytes.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(Item));
  }

  std::string bytes;
};

/// Reads what an ArrayWriter wrote. The bytes are not trusted: every length is compared with what is there.
/// Functions throw std::runtime_error if that is less.
class ArrayReader {
 public:
  /// `bytes` must outlive this object.
  explicit ArrayReader(const std::string& bytes) : bytes_(bytes) {}

  template <class T> T take() {
    T value;
    require(sizeof(T), 1);
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }

  template <class List> List take_list() {
    using Item = typename List::value_type;
    const auto count = take<std::uint64_t>();
    require(sizeof(Item), count);
    List list(count, Item{});
    if (count > 0) std::memcpy(list.data(), bytes_.data() + at_, count * sizeof(Item));
    at_ += count * sizeof(Item);
    return list;
  }

  /// Returns a number of things that take at least `least_bytes` each.
  std::size_t take_count(std::size_t least_bytes) {
    const auto count = take<std::uint64_t>();
    require(least_bytes, count);
    return count;
  }

  bool at_end() const { return at_ == bytes_.size(); }

 private:
  void require(std::size_t item_bytes, std::uint64_t count) const {
    if (count > (bytes_.size() - at_) / item_bytes) {
      throw std::runtime_error("the arrays of a model are incomplete");
    }
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

/// Writes how many items there are, then each by `put`.
template <class Items, class Put> void put_all(const Items& items, ArrayWriter& out, const Put& put) {
  out.put(static_cast<std::uint64_t>(items.size()));
  for (const auto& item : items) put(item);
}

/// Reads what put_all wrote. Each item must take four bytes or more.
template <class Items, class Take> void take_all(Items& items, ArrayReader& in, const Take& take) {
  items.resize(in.take_count(4));
  for (auto& item : items) take(item);
}

}  // namespace taut::app
