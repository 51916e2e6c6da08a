#include "sim/bytes.hpp"

namespace taut::sim {

void ByteWriter::put_positions(std::span<const Vec3> positions_m) {
  put<std::uint64_t>(positions_m.size());
  bytes_.reserve(bytes_.size() + positions_m.size_bytes());
  for (const Vec3& p : positions_m) {
    put(p.x);
    put(p.y);
    put(p.z);
  }
}

void ByteWriter::put_text(std::string_view text) {
  put<std::uint64_t>(text.size());
  bytes_ += text;
}

std::vector<Vec3> ByteReader::get_positions(const char* what, std::size_t count) {
  get<std::uint64_t>(what, count, count);
  std::vector<Vec3> positions_m(count);
  for (Vec3& p : positions_m) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = get<double>(what);
  }
  return positions_m;
}

std::string_view ByteReader::get_text(const char* what) {
  return take(what, static_cast<std::size_t>(get<std::uint64_t>(what)));
}

void ByteReader::require_text(const char* what, std::string_view expected) {
  const std::size_t at = at_;
  const std::string_view found_text = take(what, expected.size());
  if (found_text != expected) {
    refuse(at, what, '\'' + std::string(found_text) + "', expected '" + std::string(expected) + '\'');
  }
}

void ByteReader::require_end() const {
  if (at_ != bytes_.size()) {
    refuse(at_, "the end", std::to_string(bytes_.size() - at_) + " more bytes, expected none");
  }
}

void ByteReader::require_seal() {
  const std::uint64_t hash = fnv1a(fnv1a_of_nothing, bytes_.substr(0, at_));
  get("the hash of all bytes before", hash, hash);
  require_end();
}

std::string_view ByteReader::take(const char* what, std::size_t size) {
  assert(what != nullptr);
  if (size > bytes_.size() - at_) {
    refuse(at_, what, std::to_string(bytes_.size() - at_) + " bytes, expected at least " + std::to_string(size));
  }
  at_ += size;
  return bytes_.substr(at_ - size, size);
}

void ByteReader::refuse(std::size_t at, const char* what, const std::string& found_and_expected) {
  throw BadBytes("byte " + std::to_string(at) + ", " + what + ": found " + found_and_expected);
}

}  // namespace taut::sim
