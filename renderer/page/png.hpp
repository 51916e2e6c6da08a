#pragma once

#include "prelude.hpp"

namespace taut::renderer {

/// Pixels in memory: rows from top to bottom, without padding, `channels` bytes per pixel. Colour is
/// sRGB-encoded; alpha is not premultiplied.
struct Image {
  int width_px = 0;
  int height_px = 0;
  int channels = 3;  ///< 3 = RGB, 4 = RGBA
  std::vector<std::uint8_t> pixels;

  /// Return the first byte of a pixel; 0 <= x_px < width_px, 0 <= y_px < height_px.
  std::uint8_t* at(int x_px, int y_px) { return pixels.data() + offset(x_px, y_px); }
  const std::uint8_t* at(int x_px, int y_px) const { return pixels.data() + offset(x_px, y_px); }

 private:
  std::size_t offset(int x_px, int y_px) const {
    return (static_cast<std::size_t>(y_px) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x_px)) *
           static_cast<std::size_t>(channels);
  }
};

/// Returns a black (with four channels, transparent) image. Throws std::invalid_argument unless both sizes
/// are positive and there are 3 or 4 channels.
inline Image make_image(int width_px, int height_px, int channels = 3) {
  if (width_px <= 0 || height_px <= 0) throw std::invalid_argument("an image needs a positive size");
  if (channels != 3 && channels != 4) throw std::invalid_argument("an image has 3 or 4 channels");
  Image image{width_px, height_px, channels, {}};
  image.pixels.resize(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) *
                      static_cast<std::size_t>(channels));
  return image;
}

/// One PNG tEXt entry, e.g. {"Software", "taut 0.1.0"}. Keyword: 1 to 79 Latin-1 characters.
struct PngText {
  std::string keyword;
  std::string text;
};

/// Returns a PNG file. The same image gives the same bytes. Throws std::invalid_argument for an empty image,
/// a wrong number of pixels or a bad keyword.
std::vector<std::uint8_t> encode_png(const Image& image, std::span<const PngText> texts = {});

/// Returns the tEXt entries of a PNG file. `name` appears in messages. Throws std::runtime_error if it is no PNG or a
/// broken one.
std::vector<PngText> read_png_texts(std::span<const std::uint8_t> png, const std::string& name);

}  // namespace taut::renderer
