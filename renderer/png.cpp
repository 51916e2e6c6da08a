// Portable Network Graphics (ISO/IEC 15948): signature, IHDR, tEXt, IDAT, IEND. Written here because the
// chunks are the easy part: libdeflate does the work, and text entries and threads come without global
// settings.
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "renderer/image.hpp"

namespace taut::renderer {

namespace {

using Bytes = std::vector<std::uint8_t>;

void append_u32(Bytes& bytes, std::uint32_t value) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes.push_back(static_cast<std::uint8_t>((value >> shift) & 255U));
  }
}

void append_chunk(Bytes& png, std::string_view type, std::span<const std::uint8_t> data) {
  append_u32(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = png.size();
  png.insert(png.end(), type.begin(), type.end());
  png.insert(png.end(), data.begin(), data.end());
  append_u32(png, libdeflate_crc32(0, png.data() + start, png.size() - start));
}

std::uint8_t paeth(int left, int up, int corner) {
  const int estimate = left + up - corner;
  const int to_left = std::abs(estimate - left);
  const int to_up = std::abs(estimate - up);
  const int to_corner = std::abs(estimate - corner);
  if (to_left <= to_up && to_left <= to_corner) return static_cast<std::uint8_t>(left);
  return static_cast<std::uint8_t>(to_up <= to_corner ? up : corner);
}

int predicted(int filter, int left, int up, int corner) {
  switch (filter) {
    case 1:
      return left;
    case 2:
      return up;
    case 3:
      return (left + up) / 2;
    case 4:
      return paeth(left, up, corner);
    default:
      return 0;
  }
}

// `above` is empty for the first row, where the standard has zeros.
void filter_row(int filter, std::span<const std::uint8_t> row, std::span<const std::uint8_t> above,
                std::size_t channels, std::span<std::uint8_t> out) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int left = i >= channels ? row[i - channels] : 0;
    const int up = above.empty() ? 0 : above[i];
    const int corner = above.empty() || i < channels ? 0 : above[i - channels];
    out[i] = static_cast<std::uint8_t>(row[i] - predicted(filter, left, up, corner));
  }
}

std::size_t cost(std::span<const std::uint8_t> filtered) {
  std::size_t sum = 0;
  for (const std::uint8_t byte : filtered) sum += std::min<std::size_t>(byte, 256U - byte);
  return sum;
}

// The heuristic the standard recommends: the filter with the least sum of absolute differences.
int best_filter(std::span<const std::uint8_t> row, std::span<const std::uint8_t> above, std::size_t channels,
                std::span<std::uint8_t> scratch) {
  int best = 0;
  std::size_t least = SIZE_MAX;
  for (int filter = 0; filter <= 4; ++filter) {
    filter_row(filter, row, above, channels, scratch);
    const std::size_t sum = cost(scratch);
    if (sum < least) {
      least = sum;
      best = filter;
    }
  }
  return best;
}

Bytes filtered_rows(const Image& image, int filter) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t stride = static_cast<std::size_t>(image.width_px) * channels;
  Bytes out((stride + 1) * static_cast<std::size_t>(image.height_px));
  for (int y = 0; y < image.height_px; ++y) {
    const std::span row(image.at(0, y), stride);
    const std::span above(y > 0 ? image.at(0, y - 1) : nullptr, y > 0 ? stride : 0);
    const std::span target(out.data() + static_cast<std::size_t>(y) * (stride + 1), stride + 1);
    const int used = filter >= 0 ? filter : best_filter(row, above, channels, target.subspan(1));
    target[0] = static_cast<std::uint8_t>(used);
    filter_row(used, row, above, channels, target.subspan(1));
  }
  return out;
}

Bytes compressed(const Bytes& raw, int level) {
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
      libdeflate_alloc_compressor(level), libdeflate_free_compressor);
  if (compressor == nullptr) throw std::invalid_argument("PNG: the deflate level has to be from 0 to 12");
  Bytes out(libdeflate_zlib_compress_bound(compressor.get(), raw.size()));
  out.resize(libdeflate_zlib_compress(compressor.get(), raw.data(), raw.size(), out.data(), out.size()));
  return out;
}

void check(const Image& image, PngEffort effort) {
  const bool sized = image.width_px > 0 && image.height_px > 0;
  if (!sized || (image.channels != 3 && image.channels != 4)) {
    throw std::invalid_argument("PNG: the image needs a positive size and 3 or 4 channels");
  }
  const std::size_t expected = static_cast<std::size_t>(image.width_px) *
                               static_cast<std::size_t>(image.height_px) *
                               static_cast<std::size_t>(image.channels);
  if (image.pixels.size() != expected) {
    throw std::invalid_argument("PNG: the image has " + std::to_string(image.pixels.size()) +
                                " bytes, its size needs " + std::to_string(expected));
  }
  if (effort.filter < -1 || effort.filter > 4) {
    throw std::invalid_argument("PNG: the filter has to be from -1 to 4");
  }
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, std::span<const PngText> texts, PngEffort effort) {
  check(image, effort);
  Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  Bytes header;
  append_u32(header, static_cast<std::uint32_t>(image.width_px));
  append_u32(header, static_cast<std::uint32_t>(image.height_px));
  constexpr std::uint8_t rgb_type = 2;
  constexpr std::uint8_t rgba_type = 6;
  for (const std::uint8_t byte : {std::uint8_t{8}, image.channels == 3 ? rgb_type : rgba_type,
                                  std::uint8_t{0}, std::uint8_t{0}, std::uint8_t{0}}) {
    header.push_back(byte);
  }
  append_chunk(png, "IHDR", header);
  constexpr std::array<std::uint8_t, 1> perceptual_intent{0};
  append_chunk(png, "sRGB", perceptual_intent);
  for (const PngText& entry : texts) {
    if (entry.keyword.empty() || entry.keyword.size() > 79 || entry.keyword.find('\0') != std::string::npos) {
      throw std::invalid_argument("PNG: a text keyword needs 1 to 79 characters: '" + entry.keyword + "'");
    }
    Bytes data(entry.keyword.begin(), entry.keyword.end());
    data.push_back(0);
    data.insert(data.end(), entry.text.begin(), entry.text.end());
    append_chunk(png, "tEXt", data);
  }
  append_chunk(png, "IDAT", compressed(filtered_rows(image, effort.filter), effort.deflate_level));
  append_chunk(png, "IEND", {});
  return png;
}

}  // namespace taut::renderer
