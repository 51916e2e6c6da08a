#include "renderer/light/colour_textures.hpp"

namespace taut::renderer {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Colour bytes times alpha in linear light, encoded again: [alpha][colour].
using Products = std::array<std::array<std::uint8_t, 256>, 256>;

Products make_products() {
  Products products{};
  for (std::size_t alpha = 0; alpha < 256; ++alpha) {
    for (std::size_t colour = 0; colour < 256; ++colour) {
      const float encoded = static_cast<float>(colour) / 255.0F;
      const float light = srgb_to_linear(encoded) * static_cast<float>(alpha) / 255.0F;
      products[alpha][colour] = static_cast<std::uint8_t>(255.0F * linear_to_srgb(light) + 0.5F);
    }
  }
  return products;
}

// Returns premultiplied pixels: without that, filtering transparent pixels would darken or tint the edges beside them.
Bytes premultiply(const BaseColourMap& map, const Products& products) {
  Bytes bytes = *map.rgba;
  for (std::size_t i = 0; i < bytes.size(); i += 4) {
    for (std::size_t k = 0; k < 3; ++k) bytes[i + k] = products[bytes[i + 3]][bytes[i + k]];
  }
  return bytes;
}

/// Two neighbouring pixels along one axis and the weight of the second.
struct PixelBlend {
  std::size_t first, second;
  float share;
};

// Interpolates between the last and the first pixel too, as maps repeat.
PixelBlend blend_pixels(int place, int places, int pixels) {
  const float at = (static_cast<float>(place) + 0.5F) * static_cast<float>(pixels) / static_cast<float>(places) - 0.5F;
  const int below = static_cast<int>(std::floor(at));
  return {static_cast<std::size_t>((below + pixels) % pixels), static_cast<std::size_t>((below + 1) % pixels),
          at - static_cast<float>(below)};
}

Bytes enlarge(const Bytes& from, const BaseColourMap& map, int width_px, int height_px) {
  Bytes bytes;
  bytes.reserve(std::size_t{4} * static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px));
  for (int y = 0; y < height_px; ++y) {
    const PixelBlend rows = blend_pixels(y, height_px, map.height_px);
    for (int x = 0; x < width_px; ++x) {
      const PixelBlend columns = blend_pixels(x, width_px, map.width_px);
      for (std::size_t k = 0; k < 4; ++k) {
        const auto at = [&](std::size_t row, std::size_t column) {
          return static_cast<float>(from[4 * (row * static_cast<std::size_t>(map.width_px) + column) + k]);
        };
        const float upper = std::lerp(at(rows.first, columns.first), at(rows.first, columns.second), columns.share);
        const float lower = std::lerp(at(rows.second, columns.first), at(rows.second, columns.second), columns.share);
        bytes.push_back(static_cast<std::uint8_t>(std::lerp(upper, lower, rows.share) + 0.5F));
      }
    }
  }
  return bytes;
}

// Texels per colour map. Fewer shift colours by more than a step of 255.
constexpr int texels_of_map = 256;
constexpr std::array colour_map_rows{ColourMap::viridis, ColourMap::blue_orange};

std::vector<std::uint8_t> texels() {
  std::vector<std::uint8_t> bytes(3 * texels_of_map * colour_map_rows.size());
  for (const ColourMap map : colour_map_rows) {
    auto byte = bytes.begin() + static_cast<std::ptrdiff_t>(3 * texels_of_map * ColourMapTexture::row_index(map));
    for (int i = 0; i < texels_of_map; ++i) {
      const Colour colour = colour_at(map, static_cast<float>(i) / static_cast<float>(texels_of_map - 1));
      for (int k = 0; k < 3; ++k) *byte++ = static_cast<std::uint8_t>(colour[k] * 255.0F + 0.5F);
    }
  }
  return bytes;
}

}  // namespace

int BaseColourMapTexture::add_layer(const BaseColourMap& map) {
  const auto known = std::ranges::find(maps_, map);
  const auto layer = static_cast<int>(known - maps_.begin());
  if (known == maps_.end()) maps_.push_back(map);
  return layer;
}

void BaseColourMapTexture::upload() {
  if (made_ && maps_ == uploaded_) return;
  made_.emplace(*gl_);
  bind_texture(*gl_, base_colour_maps_unit, GL_TEXTURE_2D_ARRAY, *made_);
  int width_px = 0, height_px = 0;
  for (const BaseColourMap& map : maps_) {
    width_px = std::max(width_px, map.width_px);
    height_px = std::max(height_px, map.height_px);
  }
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_SRGB8_ALPHA8, width_px, height_px, static_cast<GLsizei>(maps_.size()), 0,
                  GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  const Products products = make_products();
  for (std::size_t layer = 0; layer < maps_.size(); ++layer) {
    const BaseColourMap& map = maps_[layer];
    Bytes bytes = premultiply(map, products);
    if (map.width_px != width_px || map.height_px != height_px) bytes = enlarge(bytes, map, width_px, height_px);
    gl_->TexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, static_cast<GLint>(layer), width_px, height_px, 1, GL_RGBA,
                       GL_UNSIGNED_BYTE, bytes.data());
  }
  // Mipmaps are interpolated too; new textures repeat by default.
  gl_->GenerateMipmap(GL_TEXTURE_2D_ARRAY);
  gl_->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  uploaded_ = maps_;
}

const Texture& ColourMapTexture::texture() {
  if (made_) return *made_;
  made_.emplace(*gl_);
  gl_->BindTexture(GL_TEXTURE_2D, made_->name());
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8, texels_of_map, static_cast<GLsizei>(colour_map_rows.size()), 0, GL_RGB,
                  GL_UNSIGNED_BYTE, texels().data());
  set_sampling(*gl_, GL_TEXTURE_2D, GL_LINEAR);
  return *made_;
}

}  // namespace taut::renderer
