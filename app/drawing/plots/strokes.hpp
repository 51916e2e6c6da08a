#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "renderer/page/canvas.hpp"

namespace taut::app {

/// How a line looks. Dashes alternate with gaps, in multiples of the thickness; none: a solid line.
struct Stroke {
  renderer::Colour colour{0.0F};
  float thickness_px = 4.0F;
  std::vector<float> dashes;
};

/// The points joined in their order; dashes run on around corners.
void draw_polyline(renderer::Canvas& canvas, std::span<const glm::vec2> points, const Stroke& stroke);

/// The line as the pieces that are drawn: the whole where it is solid.
std::vector<std::vector<glm::vec2>> cut_into_dashes(std::span<const glm::vec2> points, const Stroke& stroke);

/// From a to b, bowed sideways by a fraction of its length.
std::vector<glm::vec2> bow(const glm::vec2& a, const glm::vec2& b, float sideways);

/// At most four points for every column of pixels: what thousands of samples show on paper, no more.
std::vector<glm::vec2> thinned_out(std::span<const glm::vec2> points);

}  // namespace taut::app
