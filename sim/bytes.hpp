#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// A number as it is written, on every machine: the lowest byte first.
template <typename T>
constexpr std::array<char, sizeof(T)> little_endian(T value) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) {
    std::reverse(bytes.begin(), bytes.end());
  }
  return bytes;
}

/// The 64-bit FNV-1a hash (Fowler, Noll and Vo 1991) of more bytes, going on from `hash`.
constexpr std::uint64_t fnv1a(std::uint64_t hash, std::string_view bytes) {
  constexpr std::uint64_t prime = 0x100000001B3ULL;
  for (const char byte : bytes) {
    hash = (hash ^ static_cast<std::uint8_t>(byte)) * prime;
  }
  return hash;
}

/// The hash of no bytes.
inline constexpr std::uint64_t fnv1a_of_nothing = 0xCBF29CE484222325ULL;

/// A counter that goes on from here does not overflow.
inline constexpr int most_counted = 1 << 30;

/// Bytes are not what was written: the message says where, what was found and what was expected.
struct BadBytes : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Puts plain data into bytes, without padding.
class ByteWriter {
 public:
  template <typename T>
  void put(T value) {
    const auto bytes = little_endian(value);
    bytes_.append(bytes.data(), bytes.size());
  }
  /// Their number, and then three coordinates each.
  void put_positions(std::span<const Vec3> positions_m);
  /// Its length, and then the text.
  void put_text(std::string_view text);

  /// The hash of all bytes so far. Nothing may come behind it.
  void seal() { put(fnv1a(fnv1a_of_nothing, bytes_)); }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Takes out what a ByteWriter put in, in the same order. `what` names the value in messages. Whatever the
/// bytes are, nothing is read beyond their end. Everything throws BadBytes.
class ByteReader {
 public:
  /// `bytes` has to outlive this.
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  /// Throws on what is not from `least` to `most`, both included, or no number at all.
  template <typename T>
  T get(const char* what, T least = std::numeric_limits<T>::lowest(),
        T most = std::numeric_limits<T>::max()) {
    std::array<char, sizeof(T)> raw = {};
    const std::size_t at = at_;
    const std::string_view taken = take(what, sizeof(T));
    std::copy(taken.begin(), taken.end(), raw.begin());
    const T value = std::bit_cast<T>(little_endian(raw));
    if (!(value >= least && value <= most)) {
      std::ostringstream found;
      found << +value << ", expected " << +least;
      if (least != most) {
        found << " to " << +most;
      }
      refuse(at, what, found.str());
    }
    return value;
  }
  bool get_bool(const char* what) { return get<std::uint8_t>(what, 0, 1) == 1; }
  /// In m; exactly `count` of them, all finite.
  std::vector<Vec3> get_positions(const char* what, std::size_t count);
  std::string_view get_text(const char* what);
  /// As long as the expected text, and the same.
  void require_text(const char* what, std::string_view expected);
  void require_end() const;
  /// The hash of all bytes so far, and the end.
  void require_seal();

 private:
  std::string_view take(const char* what, std::size_t size);
  [[noreturn]] static void refuse(std::size_t at, const char* what, const std::string& found_and_expected);

  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace taut::sim
