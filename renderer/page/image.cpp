#include "renderer/page/image.hpp"

#include <stb/stb_image.h>

#include <cerrno>
#include <cstdio>
#include <limits>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "renderer/page/atomic_file.hpp"

namespace taut::renderer {

namespace {

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& path) {
  const auto fail = [&path](int error) {
    throw std::runtime_error("cannot read '" + path.string() +
                             "': " + std::generic_category().message(error));
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (file == nullptr) fail(errno);
  std::vector<std::uint8_t> bytes;
  std::uint8_t block[65536];
  errno = 0;
  for (std::size_t count = 0; (count = std::fread(block, 1, sizeof block, file.get())) > 0;) {
    bytes.insert(bytes.end(), block, block + count);
  }
  if (std::ferror(file.get()) != 0) fail(errno);
  return bytes;
}

}  // namespace

Image make_image(int width_px, int height_px, int channels) {
  if (width_px <= 0 || height_px <= 0) throw std::invalid_argument("an image needs a positive size");
  if (channels != 3 && channels != 4) throw std::invalid_argument("an image has 3 or 4 channels");
  Image image{width_px, height_px, channels, {}};
  image.pixels.resize(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) *
                      static_cast<std::size_t>(channels));
  return image;
}

void write_png(const std::filesystem::path& path, const Image& image, std::span<const PngText> texts,
               PngEffort effort) {
  write_file_atomically(path, encode_png(image, texts, effort));
}

Image decode_png(std::span<const std::uint8_t> bytes, int channels) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::runtime_error("not a PNG image: larger than 2 GB");
  }
  int width_px = 0;
  int height_px = 0;
  int found_channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width_px, &height_px,
                            &found_channels, channels),
      stbi_image_free);
  if (pixels == nullptr) throw std::runtime_error(std::string("not a PNG image: ") + stbi_failure_reason());
  Image image = make_image(width_px, height_px, channels);
  image.pixels.assign(pixels.get(), pixels.get() + image.pixels.size());
  return image;
}

Image read_png(const std::filesystem::path& path, int channels) {
  const std::vector<std::uint8_t> bytes = read_bytes(path);
  try {
    return decode_png(bytes, channels);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("cannot read '" + path.string() + "': " + error.what());
  }
}

}  // namespace taut::renderer
