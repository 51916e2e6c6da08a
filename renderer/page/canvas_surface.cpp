#include "renderer/page/canvas_surface.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace taut::renderer {

namespace {

std::uint32_t premultiplied(const std::uint8_t* pixel, bool has_alpha) {
  const unsigned alpha = has_alpha ? pixel[3] : 255U;
  const auto part = [alpha](unsigned value) { return (value * alpha + 127U) / 255U; };
  return (alpha << 24U) | (part(pixel[0]) << 16U) | (part(pixel[1]) << 8U) | part(pixel[2]);
}

}  // namespace

SurfaceHandle checked(cairo_surface_t* made) {
  SurfaceHandle handle(made, cairo_surface_destroy);
  const cairo_status_t status = cairo_surface_status(made);
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(std::string("cannot make a canvas: ") + cairo_status_to_string(status));
  }
  return handle;
}

// Cairo keeps pixels as native 32-bit words, alpha highest.
SurfaceHandle to_cairo(const Image& image) {
  const bool has_alpha = image.channels == 4;
  SurfaceHandle surface = checked(cairo_image_surface_create(
      has_alpha ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24, image.width_px, image.height_px));
  cairo_surface_flush(surface.get());
  unsigned char* data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < image.height_px; ++y) {
    for (int x = 0; x < image.width_px; ++x) {
      const std::uint32_t word = premultiplied(image.at(x, y), has_alpha);
      std::memcpy(data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x, &word, 4);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

Image from_cairo(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  const bool has_alpha = cairo_image_surface_get_format(surface) == CAIRO_FORMAT_ARGB32;
  Image image = make_image(cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface),
                           has_alpha ? 4 : 3);
  for (int y = 0; y < image.height_px; ++y) {
    for (int x = 0; x < image.width_px; ++x) {
      std::uint32_t word = 0;
      std::memcpy(&word, data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x, 4);
      std::uint8_t* pixel = image.at(x, y);
      const unsigned alpha = has_alpha ? word >> 24U : 255U;
      for (unsigned i = 0; i < 3; ++i) {
        const unsigned part = (word >> (16U - 8U * i)) & 255U;
        pixel[i] = static_cast<std::uint8_t>((part * 255U + alpha / 2U) / std::max(alpha, 1U));
      }
      if (has_alpha) pixel[3] = static_cast<std::uint8_t>(alpha);
    }
  }
  return image;
}

}  // namespace taut::renderer
