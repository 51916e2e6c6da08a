#include "renderer/gl/colour_map_texture.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace taut::renderer {

namespace {

// Texels for each colour map. Fewer shift colours by more than a step of 255.
constexpr int texels_of_map = 256;
constexpr std::array rows{ColourMap::viridis, ColourMap::blue_orange};

std::vector<std::uint8_t> texels() {
  std::vector<std::uint8_t> bytes(3 * texels_of_map * rows.size());
  for (const ColourMap map : rows) {
    auto byte = bytes.begin() + static_cast<std::ptrdiff_t>(3 * texels_of_map * ColourMapTexture::row_of(map));
    for (int i = 0; i < texels_of_map; ++i) {
      const Colour colour = colour_at(map, static_cast<float>(i) / static_cast<float>(texels_of_map - 1));
      for (int k = 0; k < 3; ++k) *byte++ = static_cast<std::uint8_t>(colour[k] * 255.0F + 0.5F);
    }
  }
  return bytes;
}

}  // namespace

const Texture& ColourMapTexture::texture() {
  if (made_) return *made_;
  made_.emplace(*gl_);
  gl_->BindTexture(GL_TEXTURE_2D, made_->name());
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8, texels_of_map, static_cast<GLsizei>(rows.size()), 0, GL_RGB,
                  GL_UNSIGNED_BYTE, texels().data());
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return *made_;
}

}  // namespace taut::renderer
