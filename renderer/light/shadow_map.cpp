#include "renderer/light/shadow_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>

#include "renderer/light/rasterise_triangle.hpp"
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

void ShadowMap::resize(int side_px) {
  if (side_px == side_) return;
  side_ = side_px;
  drawn_ = {};
  texels_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), 1.0F);
}

void ShadowMap::clear() {
  for (int y = drawn_.lower.y; y < drawn_.upper.y; ++y) {
    const auto row = texels_.begin() + static_cast<std::ptrdiff_t>(y) * side_;
    std::fill(row + drawn_.lower.x, row + drawn_.upper.x, 1.0F);
  }
  drawn_ = {};
}

void ShadowMap::include(const std::vector<glm::vec3>& points) {
  glm::vec2 lower{INFINITY};
  glm::vec2 upper{-INFINITY};
  for (const glm::vec3& point : points) {
    lower = glm::min(lower, glm::vec2{point});
    upper = glm::max(upper, glm::vec2{point});
  }
  if (!(lower.x <= upper.x && lower.y <= upper.y)) return;
  const MapArea own{{whole_within(lower.x - 1.0F, 0, side_), whole_within(lower.y - 1.0F, 0, side_)},
                    {whole_within(upper.x + 2.0F, 0, side_), whole_within(upper.y + 2.0F, 0, side_)}};
  const bool first = drawn_.lower == drawn_.upper;
  drawn_ = first ? own : MapArea{glm::min(drawn_.lower, own.lower), glm::max(drawn_.upper, own.upper)};
}

void ShadowMap::draw(const glm::mat4& world_to_map, std::span<const glm::vec3> positions,
                     std::span<const std::uint32_t> triangles) {
  project_to_map(world_to_map, side_, positions, projected_);
  include(projected_);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const glm::vec3& a = projected_[triangles[i]];
    const glm::vec3& b = projected_[triangles[i + 1]];
    const glm::vec3& c = projected_[triangles[i + 2]];
    const float least = std::min({a.z, b.z, c.z});
    rasterise_triangle(a, b, c, side_, [&](const TriangleSpan& span) {
      float* row = texels_.data() + static_cast<std::ptrdiff_t>(span.row) * side_;
      for (int column = span.first; column <= span.last; ++column) {
        // On a needle's edge the slope may lead astray.
        const float depth = std::max(span.depth + span.depth_step * static_cast<float>(column), least);
        row[column] = std::min(row[column], depth);
      }
    });
  }
}

float ShadowMap::depth_at(const glm::vec2& place) const {
  const glm::vec2 texel = place * static_cast<float>(side_);
  const auto highest = static_cast<float>(side_);
  if (!(texel.x >= 0.0F && texel.y >= 0.0F && texel.x < highest && texel.y < highest)) return 1.0F;
  return texels_[static_cast<std::size_t>(static_cast<int>(texel.y) * side_ + static_cast<int>(texel.x))];
}

}  // namespace taut::renderer
