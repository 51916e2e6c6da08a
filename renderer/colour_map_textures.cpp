#include "renderer/colour_map_textures.hpp"

#include <array>
#include <cstdint>

namespace taut::renderer {

const Texture& ColourMapTextures::get(ColourMap map) {
  const auto found = textures.find(map);
  if (found != textures.end()) return found->second;
  constexpr int width = 256;
  std::array<std::uint8_t, 3 * width> texels{};
  for (int i = 0; i < width; ++i) {
    const Colour colour = colour_at(map, static_cast<float>(i) / static_cast<float>(width - 1));
    for (int k = 0; k < 3; ++k) {
      texels[static_cast<std::size_t>(3 * i + k)] = static_cast<std::uint8_t>(colour[k] * 255.0F + 0.5F);
    }
  }
  const Texture& texture = textures.emplace(map, Texture(*gl)).first->second;
  gl->BindTexture(GL_TEXTURE_2D, texture.name());
  gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl->TexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8, width, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
  gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace taut::renderer
