#pragma once

#include "prelude.hpp"

namespace taut::renderer {

/// Red, green and blue, sRGB-encoded, each 0 to 1. All colours in this library's interface are encoded; shading
/// converts them to linear light.
using Colour = glm::vec3;

/// Returns the colour 0xRRGGBB.
constexpr Colour rgb(std::uint32_t hex) {
  return {static_cast<float>((hex >> 16U) & 255U) / 255.0F, static_cast<float>((hex >> 8U) & 255U) / 255.0F,
          static_cast<float>(hex & 255U) / 255.0F};
}

/// Return one channel converted by the transfer function of sRGB (IEC 61966-2-1). Arguments are clamped to 0..1.
float srgb_to_linear(float encoded);
float linear_to_srgb(float linear);

/// Returns the colour in linear light, each channel 0 to 1.
glm::vec3 linear_light(const Colour& colour);

/// Returns the colour of the reverse of cloth with this outside colour: paler and greyer.
Colour reverse_colour(const Colour& outside);

/// Colour maps ordered by lightness, so that they can be read in grey and by colour-blind readers.
enum class ColourMap {
  viridis,      ///< dark violet to yellow, lightness rises throughout
  blue_orange,  ///< diverging: blue below, near white in the middle, orange above
};

/// Returns the colour at position t of the map. t is clamped to 0..1; NaN gives a neutral grey.
Colour colour_at(ColourMap map, float t);

}  // namespace taut::renderer
