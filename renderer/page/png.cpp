// The chunks, the filters and their numbers are those of the PNG specification (ISO/IEC 15948). libdeflate
// compresses several times faster than zlib.
#include "renderer/page/png.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace taut::renderer {

namespace {

using Bytes = std::vector<std::uint8_t>;
using BytesView = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 8> signature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t frame_bytes = 12;  // length, type and checksum around a chunk's data

void append_u32(Bytes& bytes, std::uint32_t value) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes.push_back(static_cast<std::uint8_t>((value >> shift) & 255U));
  }
}

std::uint32_t u32_at(BytesView bytes) {
  return (std::uint32_t{bytes[0]} << 24U) | (std::uint32_t{bytes[1]} << 16U) |
         (std::uint32_t{bytes[2]} << 8U) | std::uint32_t{bytes[3]};
}

void append_chunk(Bytes& png, std::string_view type, BytesView data) {
  append_u32(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = png.size();
  png.insert(png.end(), type.begin(), type.end());
  png.insert(png.end(), data.begin(), data.end());
  append_u32(png, libdeflate_crc32(0, png.data() + start, png.size() - start));
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
  if (effort.deflate_level < 0 || effort.deflate_level > 12) {
    throw std::invalid_argument("PNG: the deflate level has to be from 0 to 12");
  }
  if (effort.filter < -1 || effort.filter > 4) {
    throw std::invalid_argument("PNG: the filter has to be from -1 to 4");
  }
}

void append_text(Bytes& png, const PngText& entry) {
  if (entry.keyword.empty() || entry.keyword.size() > 79 || entry.keyword.find('\0') != std::string::npos) {
    throw std::invalid_argument("PNG: a text keyword needs 1 to 79 characters: '" + entry.keyword + "'");
  }
  Bytes data(entry.keyword.begin(), entry.keyword.end());
  data.push_back(0);
  data.insert(data.end(), entry.text.begin(), entry.text.end());
  append_chunk(png, "tEXt", data);
}

int paeth(int left, int above, int corner) {
  const int to_left = std::abs(above - corner);
  const int to_above = std::abs(left - corner);
  const int to_corner = std::abs(left + above - 2 * corner);
  if (to_left <= to_above && to_left <= to_corner) return left;
  return to_above <= to_corner ? above : corner;
}

// A row less what its neighbours let expect. Both rows have a pixel of zeros in front.
void filter_row(int filter, BytesView row, BytesView row_above, std::size_t channels, std::uint8_t* out) {
  const auto each = [&](auto expected) {
    for (std::size_t i = channels; i < row.size(); ++i) {
      *out++ = static_cast<std::uint8_t>(
          row[i] - expected(int{row[i - channels]}, int{row_above[i]}, int{row_above[i - channels]}));
    }
  };
  switch (filter) {
    case 0:
      return each([](int, int, int) { return 0; });
    case 1:
      return each([](int left, int, int) { return left; });
    case 2:
      return each([](int, int above, int) { return above; });
    case 3:
      return each([](int left, int above, int) { return (left + above) / 2; });
    default:
      return each(paeth);
  }
}

// The filter whose bytes are nearest to zero all together, which deflate packs best as a rule.
int best_filter(BytesView row, BytesView row_above, std::size_t channels, std::uint8_t* scratch) {
  int best = 0;
  long least = std::numeric_limits<long>::max();
  for (int filter = 0; filter <= 4; ++filter) {
    filter_row(filter, row, row_above, channels, scratch);
    long sum = 0;
    for (std::size_t i = 0; i < row.size() - channels; ++i)
      sum += std::abs(static_cast<std::int8_t>(scratch[i]));
    best = sum < least ? filter : best;
    least = std::min(least, sum);
  }
  return best;
}

Bytes filtered(const Image& image, int filter) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t row_bytes = channels * static_cast<std::size_t>(image.width_px);
  Bytes row(channels + row_bytes), row_above(channels + row_bytes);
  Bytes bytes(static_cast<std::size_t>(image.height_px) * (1 + row_bytes));
  std::uint8_t* out = bytes.data();
  for (int y = 0; y < image.height_px; ++y, out += 1 + row_bytes) {
    std::copy_n(image.at(0, y), row_bytes, row.data() + channels);
    const int chosen = filter >= 0 ? filter : best_filter(row, row_above, channels, out + 1);
    *out = static_cast<std::uint8_t>(chosen);
    filter_row(chosen, row, row_above, channels, out + 1);
    row.swap(row_above);
  }
  return bytes;
}

Bytes compressed(BytesView bytes, int level) {
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
      libdeflate_alloc_compressor(level), libdeflate_free_compressor);
  if (compressor == nullptr) throw std::runtime_error("PNG: out of memory");
  Bytes result(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
  result.resize(
      libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), result.data(), result.size()));
  return result;
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, std::span<const PngText> texts, PngEffort effort) {
  check(image, effort);
  Bytes header;
  append_u32(header, static_cast<std::uint32_t>(image.width_px));
  append_u32(header, static_cast<std::uint32_t>(image.height_px));
  constexpr std::uint8_t bits = 8, rgb = 2, rgba = 6, perceptual_intent = 0;
  header.insert(header.end(), {bits, image.channels == 3 ? rgb : rgba, 0, 0, 0});
  Bytes png(signature.begin(), signature.end());
  append_chunk(png, "IHDR", header);
  append_chunk(png, "sRGB", {&perceptual_intent, 1});
  for (const PngText& entry : texts) append_text(png, entry);
  append_chunk(png, "IDAT", compressed(filtered(image, effort.filter), effort.deflate_level));
  append_chunk(png, "IEND", {});
  return png;
}

std::vector<PngText> read_png_texts(std::span<const std::uint8_t> png, const std::string& name) {
  if (png.size() < signature.size() || !std::equal(signature.begin(), signature.end(), png.begin())) {
    throw std::runtime_error("'" + name + "' is no PNG picture");
  }
  std::vector<PngText> texts;
  for (BytesView rest = png.subspan(signature.size());;) {
    if (rest.size() < frame_bytes || rest.size() - frame_bytes < u32_at(rest)) {
      throw std::runtime_error("the picture '" + name + "' ends in the middle");
    }
    const std::size_t length = u32_at(rest);
    const std::string type(rest.begin() + 4, rest.begin() + 8);
    const BytesView data = rest.subspan(8, length);
    if (type == "IEND") return texts;
    const auto zero = std::find(data.begin(), data.end(), std::uint8_t{0});
    if (type == "tEXt" && zero != data.end()) {
      texts.push_back({std::string(data.begin(), zero), std::string(zero + 1, data.end())});
    }
    rest = rest.subspan(frame_bytes + length);
  }
}

}  // namespace taut::renderer
