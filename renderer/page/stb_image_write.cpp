#include "renderer/page/stb_image_write.hpp"

#include <libdeflate.h>

#include <cstdlib>

namespace {

unsigned char* compress(const unsigned char* data, int size, int* compressed_size, int level) {
  libdeflate_compressor* compressor = libdeflate_alloc_compressor(level);
  if (compressor == nullptr) return nullptr;
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor, static_cast<std::size_t>(size));
  auto* compressed = static_cast<unsigned char*>(std::malloc(bound));
  if (compressed != nullptr) {
    *compressed_size = static_cast<int>(
        libdeflate_zlib_compress(compressor, data, static_cast<std::size_t>(size), compressed, bound));
  }
  libdeflate_free_compressor(compressor);
  return compressed;
}

}  // namespace

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS compress
#define STBIW_CRC32(buffer, length) libdeflate_crc32(0, buffer, static_cast<std::size_t>(length))
#include <stb/stb_image_write.h>

namespace taut::renderer {

unsigned char* stb_encode_png(const unsigned char* pixels, int width_px, int height_px, int channels,
                              int level, int filter, int* size) {
  stbi_write_png_compression_level = level;
  stbi_write_force_png_filter = filter;
  return stbi_write_png_to_mem(pixels, 0, width_px, height_px, channels, size);
}

}  // namespace taut::renderer
