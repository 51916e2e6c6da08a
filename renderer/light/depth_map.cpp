#include "renderer/light/depth_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>

#include "renderer/light/triangle_spans.hpp"
#include "renderer/page/whole_number.hpp"

namespace taut::renderer {

void project_to_map(const glm::mat4& world_to_map, int side_px, std::span<const glm::vec3> positions,
                    std::vector<glm::vec3>& projected) {
  const auto scale = static_cast<float>(side_px);
  projected.resize(positions.size());
  std::transform(positions.begin(), positions.end(), projected.begin(), [&](const glm::vec3& position) {
    const glm::vec3 place{world_to_map * glm::vec4{position, 1.0F}};
    return glm::vec3{place.x * scale, place.y * scale, place.z};
  });
}

void DepthMap::resize(int side_px) {
  if (side_px == side) return;
  side = side_px;
  drawn_area = {};
  texels.assign(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 1.0F);
}

void DepthMap::clear() {
  for (int y = drawn_area.lower.y; y < drawn_area.upper.y; ++y) {
    const auto row = texels.begin() + static_cast<std::ptrdiff_t>(y) * side;
    std::fill(row + drawn_area.lower.x, row + drawn_area.upper.x, 1.0F);
  }
  drawn_area = {};
}

void DepthMap::include(const std::vector<glm::vec3>& points) {
  glm::vec2 lower{INFINITY};
  glm::vec2 upper{-INFINITY};
  for (const glm::vec3& point : points) {
    lower = glm::min(lower, glm::vec2{point});
    upper = glm::max(upper, glm::vec2{point});
  }
  if (!(lower.x <= upper.x && lower.y <= upper.y)) return;
  const MapArea own{{whole_within(lower.x - 1.0F, 0, side), whole_within(lower.y - 1.0F, 0, side)},
                    {whole_within(upper.x + 2.0F, 0, side), whole_within(upper.y + 2.0F, 0, side)}};
  const bool first = drawn_area.lower == drawn_area.upper;
  drawn_area =
      first ? own : MapArea{glm::min(drawn_area.lower, own.lower), glm::max(drawn_area.upper, own.upper)};
}

void DepthMap::draw(const glm::mat4& world_to_map, std::span<const glm::vec3> positions,
                    std::span<const std::uint32_t> triangles) {
  project_to_map(world_to_map, side, positions, projected);
  include(projected);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const glm::vec3& a = projected[triangles[i]];
    const glm::vec3& b = projected[triangles[i + 1]];
    const glm::vec3& c = projected[triangles[i + 2]];
    const float least = std::min({a.z, b.z, c.z});
    triangle_spans(a, b, c, side, [&](const TriangleSpan& span) {
      float* row = texels.data() + static_cast<std::ptrdiff_t>(span.row) * side;
      for (int column = span.first; column <= span.last; ++column) {
        // On a needle's edge the slope may lead astray.
        const float depth = std::max(span.depth + span.depth_step * static_cast<float>(column), least);
        row[column] = std::min(row[column], depth);
      }
    });
  }
}

float DepthMap::depth_at(const glm::vec2& place) const {
  const glm::vec2 texel = place * static_cast<float>(side);
  const auto highest = static_cast<float>(side);
  if (!(texel.x >= 0.0F && texel.y >= 0.0F && texel.x < highest && texel.y < highest)) return 1.0F;
  return texels[static_cast<std::size_t>(static_cast<int>(texel.y) * side + static_cast<int>(texel.x))];
}

}  // namespace taut::renderer
