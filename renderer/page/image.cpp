#include "renderer/page/image.hpp"

#include <stdexcept>

namespace taut::renderer {

Image make_image(int width_px, int height_px, int channels) {
  if (width_px <= 0 || height_px <= 0) throw std::invalid_argument("an image needs a positive size");
  if (channels != 3 && channels != 4) throw std::invalid_argument("an image has 3 or 4 channels");
  Image image{width_px, height_px, channels, {}};
  image.pixels.resize(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) *
                      static_cast<std::size_t>(channels));
  return image;
}

}  // namespace taut::renderer
