// stb_image_write filters the rows and lays out the file; libdeflate, which is several times faster than its
// own compressor, compresses, and text entries are put in behind the header.
#include <libdeflate.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string_view>

#include "renderer/page/image.hpp"
#include "renderer/page/stb_image_write.hpp"

namespace taut::renderer {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t signature_and_header_bytes = 8 + 25;

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

Bytes extra_chunks(std::span<const PngText> texts) {
  Bytes chunks;
  constexpr std::array<std::uint8_t, 1> perceptual_intent{0};
  append_chunk(chunks, "sRGB", perceptual_intent);
  for (const PngText& entry : texts) {
    if (entry.keyword.empty() || entry.keyword.size() > 79 || entry.keyword.find('\0') != std::string::npos) {
      throw std::invalid_argument("PNG: a text keyword needs 1 to 79 characters: '" + entry.keyword + "'");
    }
    Bytes data(entry.keyword.begin(), entry.keyword.end());
    data.push_back(0);
    data.insert(data.end(), entry.text.begin(), entry.text.end());
    append_chunk(chunks, "tEXt", data);
  }
  return chunks;
}

Bytes encoded_by_stb(const Image& image, PngEffort effort) {
  // Level and filter are globals of stb_image_write.
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  int size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> png(
      stb_encode_png(image.pixels.data(), image.width_px, image.height_px, image.channels,
                     effort.deflate_level, effort.filter, &size),
      std::free);
  if (png == nullptr) throw std::runtime_error("PNG: out of memory");
  return {png.get(), png.get() + size};
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, std::span<const PngText> texts, PngEffort effort) {
  check(image, effort);
  const Bytes extra = extra_chunks(texts);
  Bytes png = encoded_by_stb(image, effort);
  png.insert(png.begin() + signature_and_header_bytes, extra.begin(), extra.end());
  return png;
}

}  // namespace taut::renderer
