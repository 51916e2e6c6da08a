#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "renderer/page/canvas.hpp"

namespace taut::app {

/// How a line looks. `dashes` holds lengths of dashes and gaps in turn, as multiples of the thickness. Empty:
/// a solid line.
struct Stroke {
  renderer::Colour colour{0.0F};
  float thickness_px = 4.0F;
  std::vector<float> dashes;
};

/// Draws a line through the points in their order. Dashes continue around corners.
void draw_polyline(renderer::Canvas& canvas, std::span<const glm::vec2> points, const Stroke& stroke);

/// The pieces of the line that are drawn. A solid line is one piece.
std::vector<std::vector<glm::vec2>> cut_into_dashes(std::span<const glm::vec2> points, const Stroke& stroke);

/// A curved line from a to b. In its middle it is away from the straight line by `sideways` times its length.
std::vector<glm::vec2> bow(const glm::vec2& a, const glm::vec2& b, float sideways);

/// At most four points for each column of pixels. The curve looks the same, because the lowest and the
/// highest point of each column stay.
std::vector<glm::vec2> thinned_out(std::span<const glm::vec2> points);

}  // namespace taut::app
