// Text chunks, which stb_image_write lacks, follow the PNG specification (ISO/IEC 15948).
#include "renderer/page/png.hpp"

#include <libdeflate.h>

namespace taut::renderer {
namespace {

// Level of libdeflate, which packs rendered pictures five times as fast as stb and smaller.
constexpr int deflate_level = 3;

/// Compresses for stb_image_write: returns bytes for free(), or null without memory.
unsigned char* compress(const unsigned char* bytes, int count, int* compressed_count, int /*quality*/) {
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
      libdeflate_alloc_compressor(deflate_level), libdeflate_free_compressor);
  if (compressor == nullptr) return nullptr;
  const auto size = static_cast<std::size_t>(count);
  const std::size_t max_bytes = libdeflate_zlib_compress_bound(compressor.get(), size);
  auto* compressed = static_cast<unsigned char*>(std::malloc(max_bytes));
  if (compressed == nullptr) return nullptr;
  *compressed_count = static_cast<int>(libdeflate_zlib_compress(compressor.get(), bytes, size, compressed, max_bytes));
  return compressed;
}

}  // namespace
}  // namespace taut::renderer

#define STBIW_ZLIB_COMPRESS taut::renderer::compress
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace taut::renderer {
namespace {

using Bytes = std::vector<std::uint8_t>;
using BytesView = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 8> signature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t frame_bytes = 12;               // length, type and checksum around a chunk's data
constexpr std::ptrdiff_t header_bytes = 8 + 12 + 13;  // the signature and the first chunk, the size

void append_u32(Bytes& bytes, std::uint32_t value) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes.push_back(static_cast<std::uint8_t>((value >> shift) & 255U));
}

std::uint32_t u32_at(BytesView bytes) {
  return (std::uint32_t{bytes[0]} << 24U) | (std::uint32_t{bytes[1]} << 16U) | (std::uint32_t{bytes[2]} << 8U) |
         std::uint32_t{bytes[3]};
}

void append_chunk(Bytes& png, std::string_view type, BytesView data) {
  append_u32(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = png.size();
  png.insert(png.end(), type.begin(), type.end());
  png.insert(png.end(), data.begin(), data.end());
  append_u32(png, libdeflate_crc32(0, png.data() + start, png.size() - start));
}

void check(const Image& image) {
  const bool sized = image.width_px > 0 && image.height_px > 0;
  if (!sized || (image.channels != 3 && image.channels != 4)) {
    throw std::invalid_argument("PNG: the image needs a positive size and 3 or 4 channels");
  }
  const std::size_t expected = static_cast<std::size_t>(image.width_px) * static_cast<std::size_t>(image.height_px) *
                               static_cast<std::size_t>(image.channels);
  if (image.pixels.size() != expected) {
    throw std::invalid_argument("PNG: the image has " + std::to_string(image.pixels.size()) +
                                " bytes, its size needs " + std::to_string(expected));
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

// Filters by the difference to the left pixel: it packs as well as the best filter per row, in half the time.
Bytes encode(const Image& image) {
  static const bool is_set = (stbi_write_force_png_filter = 1) == 1;
  int size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> png(
      is_set ? stbi_write_png_to_mem(image.pixels.data(), image.width_px * image.channels, image.width_px,
                                     image.height_px, image.channels, &size)
             : nullptr,
      std::free);
  if (png == nullptr) throw std::bad_alloc();
  return {png.get(), png.get() + size};
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, std::span<const PngText> texts) {
  check(image);
  constexpr std::uint8_t perceptual_intent = 0;
  Bytes chunks;
  append_chunk(chunks, "sRGB", {&perceptual_intent, 1});
  for (const PngText& entry : texts) append_text(chunks, entry);
  Bytes png = encode(image);
  png.insert(png.begin() + header_bytes, chunks.begin(), chunks.end());
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
    const auto zero = std::ranges::find(data, std::uint8_t{0});
    if (type == "tEXt" && zero != data.end()) {
      texts.push_back({std::string(data.begin(), zero), std::string(zero + 1, data.end())});
    }
    rest = rest.subspan(frame_bytes + length);
  }
}

}  // namespace taut::renderer
