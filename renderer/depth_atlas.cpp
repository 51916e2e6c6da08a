#include "renderer/depth_atlas.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taut::renderer {

namespace {

// Twice the signed area of a, b and p.
float edge(const glm::vec3& a, const glm::vec3& b, float x, float y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

struct Range {
  int first;
  int last;
};

// The pixels whose centres lie between the least and the greatest of three coordinates.
Range centres_between(float a, float b, float c, int side_px) {
  const auto highest = static_cast<float>(side_px);
  const float least = std::clamp(std::min({a, b, c}), 0.0F, highest);
  const float greatest = std::clamp(std::max({a, b, c}), 0.0F, highest);
  return {static_cast<int>(least + 0.5F), std::min(static_cast<int>(greatest + 0.5F), side_px) - 1};
}

}  // namespace

DepthAtlas::DepthAtlas(int columns_, int rows_, int cell_px_)
    : columns(columns_),
      rows(rows_),
      cell_px(cell_px_),
      texels(static_cast<std::size_t>(columns_ * cell_px_) * static_cast<std::size_t>(rows_ * cell_px_),
             1.0F) {}

void DepthAtlas::clear() {
  std::fill(texels.begin(), texels.end(), 1.0F);
}

void DepthAtlas::draw(int cell, const glm::mat4& world_to_cell, std::span<const glm::vec3> positions,
                      std::span<const std::uint32_t> triangles) {
  const auto side = static_cast<float>(cell_px);
  projected.clear();
  for (const glm::vec3& position : positions) {
    const glm::vec3 place{world_to_cell * glm::vec4{position, 1.0F}};
    projected.emplace_back(place.x * side, place.y * side, place.z);
  }
  const int corner = (cell / columns) * cell_px * width_px() + (cell % columns) * cell_px;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    fill(texels.data() + corner, projected[triangles[i]], projected[triangles[i + 1]],
         projected[triangles[i + 2]]);
  }
}

float DepthAtlas::depth_at(const glm::vec2& place) const {
  const glm::vec2 texel = place * static_cast<float>(cell_px);
  const auto side = static_cast<float>(cell_px);
  if (!(texel.x >= 0.0F && texel.y >= 0.0F && texel.x < side && texel.y < side)) return 1.0F;
  return texels[static_cast<std::size_t>(static_cast<int>(texel.y) * width_px() + static_cast<int>(texel.x))];
}

void DepthAtlas::fill(float* corner, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const Range across = centres_between(a.x, b.x, c.x, cell_px);
  const Range up = centres_between(a.y, b.y, c.y, cell_px);
  if (across.first > across.last || up.first > up.last) return;
  const float area = edge(a, b, c.x, c.y);
  if (area == 0.0F) return;
  const float to_share = 1.0F / area;
  // A hair to spare on every side: neighbours may both fill a shared edge, but never leave a gap.
  constexpr float spare = -1e-4F;
  for (int row = up.first; row <= up.last; ++row) {
    const float y = static_cast<float>(row) + 0.5F;
    float* texel = corner + row * width_px();
    for (int column = across.first; column <= across.last; ++column) {
      const float x = static_cast<float>(column) + 0.5F;
      const float of_a = edge(b, c, x, y) * to_share;
      const float of_b = edge(c, a, x, y) * to_share;
      const float of_c = 1.0F - of_a - of_b;
      if (of_a < spare || of_b < spare || of_c < spare) continue;
      const float depth = of_a * a.z + of_b * b.z + of_c * c.z;
      texel[column] = std::min(texel[column], depth);
    }
  }
}

}  // namespace taut::renderer
