#pragma once

#include "prelude.hpp"

namespace taut::app {

/// Writes values one after the other, as they are in memory, for another process of this program. A value is trivially
/// copyable, a list of values, or of a type that says of what it consists: `fields(archive, value)` calls the archive
/// with references to these, and serves for writing and for reading. A std::size_t takes eight bytes on every machine:
/// pages read what others wrote.
class ArrayWriter {
 public:
  template <class... Values> void operator()(const Values&... values) { (put(values), ...); }

  std::string bytes;

 private:
  template <class T> void put(const T& value) {
    if constexpr (std::same_as<T, std::size_t> && sizeof(T) != sizeof(std::uint64_t)) {
      put(std::uint64_t{value});
    } else if constexpr (std::is_trivially_copyable_v<T>) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
    } else {
      fields(*this, value);
    }
  }

  template <class T> void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }

  template <class List>
  requires requires(List list) { list.resize(0); }
  void put(const List& list) {
    put(static_cast<std::uint64_t>(list.size()));
    if constexpr (std::is_trivially_copyable_v<typename List::value_type>) {
      bytes.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(typename List::value_type));
    } else {
      for (const auto& item : list) put(item);
    }
  }
};

/// Reads what an ArrayWriter wrote. The bytes are not trusted: every length is compared with what is there.
/// Functions throw std::runtime_error if that is less.
class ArrayReader {
 public:
  /// `bytes` must outlive this object.
  explicit ArrayReader(const std::string& bytes) : bytes_(bytes) {}

  template <class... Values> void operator()(Values&... values) { (take(values), ...); }

  bool at_end() const { return at_ == bytes_.size(); }

 private:
  template <class T> void take(T& value) {
    if constexpr (std::same_as<T, std::size_t> && sizeof(T) != sizeof(std::uint64_t)) {
      std::uint64_t wide = 0;
      take(wide);
      value = static_cast<T>(wide);
    } else if constexpr (std::is_trivially_copyable_v<T>) {
      copy(&value, sizeof(T), 1);
    } else {
      fields(*this, value);
    }
  }

  void take(bool& value) {
    std::uint8_t byte = 0;
    take(byte);
    value = byte != 0;
  }

  template <class T> void take(std::optional<T>& value) {
    bool has_value = false;
    take(has_value);
    if (has_value) take(value.emplace());
  }

  template <class List>
  requires requires(List list) { list.resize(0); }
  void take(List& list) {
    using Item = typename List::value_type;
    constexpr bool is_copied = std::is_trivially_copyable_v<Item>;
    std::uint64_t count = 0;
    take(count);
    require(is_copied ? sizeof(Item) : 4, count);  // other items take no less
    list.resize(count);
    if constexpr (is_copied) {
      copy(list.data(), sizeof(Item), count);
    } else {
      for (auto& item : list) take(item);
    }
  }

  void copy(void* to, std::size_t item_bytes, std::uint64_t count) {
    require(item_bytes, count);
    if (count > 0) std::memcpy(to, bytes_.data() + at_, count * item_bytes);
    at_ += count * item_bytes;
  }

  void require(std::size_t item_bytes, std::uint64_t count) const {
    if (count > (bytes_.size() - at_) / item_bytes) {
      throw std::runtime_error("the arrays of a model are incomplete");
    }
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace taut::app
