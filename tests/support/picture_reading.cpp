#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include "picture_reading.hpp"

#include <stb/stb_image.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace taut::tests {
namespace {

using Pixels = std::unique_ptr<stbi_uc, void (*)(void*)>;

renderer::Image to_image(const Pixels& pixels, int width_px, int height_px, int channels, const std::string& name) {
  if (pixels == nullptr) {
    throw std::runtime_error("cannot read '" + name + "': " + stbi_failure_reason());
  }
  renderer::Image image = renderer::make_image(width_px, height_px, channels);
  image.pixels.assign(pixels.get(), pixels.get() + image.pixels.size());
  return image;
}

}  // namespace

renderer::Image read_png(const std::filesystem::path& path, int channels) {
  int width_px = 0, height_px = 0, found_channels = 0;
  const Pixels pixels(stbi_load(path.c_str(), &width_px, &height_px, &found_channels, channels),
                      stbi_image_free);
  return to_image(pixels, width_px, height_px, channels, path.string());
}

renderer::Image decode_png(std::span<const std::uint8_t> bytes, int channels) {
  int width_px = 0, height_px = 0, found_channels = 0;
  const Pixels pixels(stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width_px,
                                            &height_px, &found_channels, channels),
                      stbi_image_free);
  return to_image(pixels, width_px, height_px, channels, "a PNG in memory");
}

}  // namespace taut::tests
