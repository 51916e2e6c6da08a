#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "renderer/page/whole_number.hpp"

namespace taut::renderer {

/// A span of scanline rasterisation: the pixels of one row whose centres lie in a triangle.
struct TriangleSpan {
  int row = 0;
  int first = 0;            ///< first column
  int last = 0;             ///< last column, included
  float depth = 0.0F;       ///< at the centre of column 0
  float depth_step = 0.0F;  ///< from column to column
};

namespace detail {

// Where an edge cuts the rows: column = offset + slope * row. Rows the edge does not reach bound nothing.
struct RowCut {
  float slope = 0.0F;
  float offset = 0.0F;
  bool is_left = false;
};

inline RowCut row_cut(const glm::vec3& from, const glm::vec3& to, bool counter_clockwise) {
  const float slope = (to.x - from.x) / (to.y - from.y);
  return {slope, from.x - slope * from.y, (to.y < from.y) == counter_clockwise};
}

}  // namespace detail

/// Calls `fill` with every span of a triangle on a square of side_px. Corners: x and y in pixels, z the
/// depth. The winding does not matter. Neighbours may share pixels on their edge, but never leave a gap.
/// Spans are clipped to the square, also for corners that are not finite.
template <typename Fill>
void rasterise_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, int side_px,
                        Fill&& fill) {
  // A hair to spare on every side, px.
  constexpr float spare = 1e-3F;
  const auto first_centre = [side_px](float edge) { return whole_within(edge + 0.5F - spare, 0, side_px); };
  const auto last_centre = [side_px](float edge) {
    return whole_within(edge + 0.5F + spare, 0, side_px) - 1;
  };
  const int first_row = first_centre(std::min({a.y, b.y, c.y}));
  const int last_row = last_centre(std::max({a.y, b.y, c.y}));
  const float leftmost = std::min({a.x, b.x, c.x});
  const float rightmost = std::max({a.x, b.x, c.x});
  const int first_column = first_centre(leftmost);
  const int last_column = last_centre(rightmost);
  if (first_row > last_row || first_column > last_column) return;
  const glm::vec3 ab = b - a;
  const glm::vec3 ac = c - a;
  const float twice_area = ab.x * ac.y - ac.x * ab.y;
  if (!(std::abs(twice_area) > 0.0F && std::isfinite(twice_area))) return;
  const glm::vec2 slope = glm::vec2{ab.z * ac.y - ac.z * ab.y, ab.x * ac.z - ac.x * ab.z} / twice_area;
  const bool turn = twice_area > 0.0F;
  std::array<detail::RowCut, 3> cuts;
  std::size_t count = 0;
  if (a.y != b.y) cuts[count++] = detail::row_cut(a, b, turn);
  if (b.y != c.y) cuts[count++] = detail::row_cut(b, c, turn);
  if (c.y != a.y) cuts[count++] = detail::row_cut(c, a, turn);
  for (int row = first_row; row <= last_row; ++row) {
    const float y = static_cast<float>(row) + 0.5F;
    float left = leftmost;
    float right = rightmost;
    for (std::size_t i = 0; i < count; ++i) {
      const float x = cuts[i].offset + cuts[i].slope * y;
      left = cuts[i].is_left ? std::max(left, x) : left;
      right = cuts[i].is_left ? right : std::min(right, x);
    }
    const int first = std::max(first_centre(left), first_column);
    const int last = std::min(last_centre(right), last_column);
    if (first > last) continue;
    const float depth = a.z + (y - a.y) * slope.y + (0.5F - a.x) * slope.x;
    fill(TriangleSpan{row, first, last, depth, slope.x});
  }
}

}  // namespace taut::renderer
