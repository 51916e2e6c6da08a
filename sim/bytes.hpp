#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Returns the bytes of a number, lowest byte first on every machine.
template <typename T> constexpr std::array<char, sizeof(T)> little_endian(T value) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) {
    std::reverse(bytes.begin(), bytes.end());
  }
  return bytes;
}

/// Extends a 64-bit FNV-1a hash (Fowler, Noll and Vo 1991) by more bytes. `hash` is the hash of the bytes so far.
constexpr std::uint64_t fnv1a(std::uint64_t hash, std::string_view bytes) {
  constexpr std::uint64_t prime = 0x100000001B3ULL;
  for (const char byte : bytes) hash = (hash ^ static_cast<std::uint8_t>(byte)) * prime;
  return hash;
}

/// The hash of no bytes.
inline constexpr std::uint64_t fnv1a_of_nothing = 0xCBF29CE484222325ULL;

/// Largest accepted counter. Counting on from it does not overflow.
inline constexpr int max_counter = 1 << 30;

/// Thrown if bytes are not what a ByteWriter wrote. The message gives the place, the found and the expected value.
struct BadBytes : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Writes plain data as bytes, without padding.
class ByteWriter {
 public:
  template <typename T> void put(T value) {
    const auto bytes = little_endian(value);
    bytes_.append(bytes.data(), bytes.size());
  }
  /// Writes the number of positions, then three coordinates of each, in m.
  void put_positions(std::span<const Vec3> positions_m);
  /// Writes the length of the text in bytes, then the text.
  void put_text(std::string_view text);

  /// Writes the hash of all bytes so far. Nothing may be written after it.
  void seal() { put(fnv1a(fnv1a_of_nothing, bytes_)); }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads the values of a ByteWriter in the same order. `what` names the value in messages. No function reads beyond the
/// end of the bytes. Every function throws BadBytes if the bytes are not as expected.
class ByteReader {
 public:
  /// `bytes` must outlive this object.
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  /// Reads a number. Throws if it is not a number or outside `least` to `most`, both included.
  template <typename T>
  T get(const char* what, T least = std::numeric_limits<T>::lowest(), T most = std::numeric_limits<T>::max()) {
    std::array<char, sizeof(T)> raw = {};
    const std::size_t at = at_;
    const std::string_view taken = take(what, sizeof(T));
    std::copy(taken.begin(), taken.end(), raw.begin());
    const T value = std::bit_cast<T>(little_endian(raw));
    if (!(value >= least && value <= most)) {
      std::ostringstream found_text;
      found_text << +value << ", expected " << +least;
      if (least != most) found_text << " to " << +most;
      refuse(at, what, found_text.str());
    }
    return value;
  }
  bool get_bool(const char* what) { return get<std::uint8_t>(what, 0, 1) == 1; }
  /// Reads exactly `count` positions, in m; all must be finite.
  std::vector<Vec3> get_positions(const char* what, std::size_t count);
  std::string_view get_text(const char* what);
  /// Reads a text that must equal `expected`.
  void require_text(const char* what, std::string_view expected);
  /// Requires that all bytes have been read.
  void require_end() const;
  /// Requires the hash written by seal(), and then the end.
  void require_seal();

 private:
  std::string_view take(const char* what, std::size_t size);
  [[noreturn]] static void refuse(std::size_t at, const char* what, const std::string& found_and_expected);

  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace taut::sim
