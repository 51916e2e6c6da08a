#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace taut::renderer {

/// Red, green, blue as a colour picker shows them: sRGB-encoded, each 0 to 1. Every colour that crosses the
/// interface of this library is of this kind; shading converts to linear light by itself.
using Colour = glm::vec3;

/// 0xRRGGBB to Colour.
constexpr Colour rgb(std::uint32_t hex) {
  return {static_cast<float>((hex >> 16U) & 255U) / 255.0F, static_cast<float>((hex >> 8U) & 255U) / 255.0F,
          static_cast<float>(hex & 255U) / 255.0F};
}

/// The transfer function of IEC 61966-2-1 for one channel, 0 to 1; values outside are clamped.
float srgb_to_linear(float encoded);
float linear_to_srgb(float linear);

/// All three channels in linear light.
glm::vec3 linear_light(const Colour& colour);

/// Colour maps whose lightness tells the order to every reader, colour-blind or printing in grey.
enum class ColourMap {
  viridis,      ///< dark violet to yellow, lightness rises throughout
  blue_orange,  ///< diverging: blue below, near white in the middle, orange above
};

/// Colour at position t of the map; t is clamped to 0..1, and a NaN gives a neutral grey.
Colour colour_at(ColourMap map, float t);

}  // namespace taut::renderer
