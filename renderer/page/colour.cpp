#include "renderer/page/colour.hpp"

namespace taut::renderer {

namespace {

// Equally spaced samples of the published map (van der Walt and Smith 2015, CC0). Linear interpolation stays within two
// units of 255.
constexpr std::array viridis{rgb(0x440154), rgb(0x482878), rgb(0x3E4989), rgb(0x31688E), rgb(0x26828E),
                             rgb(0x1F9E89), rgb(0x35B779), rgb(0x6ECE58), rgb(0xB5DE2B), rgb(0xFDE725)};
// Lightness falls equally on both sides; blue and orange are distinguishable with every colour blindness.
constexpr std::array blue_orange{rgb(0x1B4F8C), rgb(0x3F7DBA), rgb(0x7FAED6), rgb(0xBDD5E8), rgb(0xF2F2EE),
                                 rgb(0xF3CFA6), rgb(0xE6A15F), rgb(0xC9722B), rgb(0x8F4A12)};

std::span<const Colour> map_samples(ColourMap map) {
  return map == ColourMap::viridis ? std::span<const Colour>(viridis) : blue_orange;
}

}  // namespace

float srgb_to_linear(float encoded) {
  const float c = std::clamp(encoded, 0.0F, 1.0F);
  return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F);
}

float linear_to_srgb(float linear) {
  const float c = std::clamp(linear, 0.0F, 1.0F);
  return c <= 0.0031308F ? c * 12.92F : 1.055F * std::pow(c, 1.0F / 2.4F) - 0.055F;
}

glm::vec3 linear_light(const Colour& colour) {
  return {srgb_to_linear(colour.r), srgb_to_linear(colour.g), srgb_to_linear(colour.b)};
}

Colour reverse_colour(const Colour& outside) {
  constexpr float greyer = 0.25F;
  constexpr float paler = 0.25F;
  const Colour grey{glm::dot(outside, glm::vec3{0.2126F, 0.7152F, 0.0722F})};
  return glm::mix(glm::mix(outside, grey, greyer), Colour{1.0F}, paler);
}

Colour colour_at(ColourMap map, float t) {
  if (std::isnan(t)) return Colour{0.5F};
  const std::span<const Colour> samples = map_samples(map);
  const float place = std::clamp(t, 0.0F, 1.0F) * static_cast<float>(samples.size() - 1);
  const auto lower = std::min(static_cast<std::size_t>(place), samples.size() - 2);
  const float fraction = place - static_cast<float>(lower);
  return samples[lower] * (1.0F - fraction) + samples[lower + 1] * fraction;
}

}  // namespace taut::renderer
