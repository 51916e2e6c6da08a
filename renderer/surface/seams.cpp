#include "renderer/surface/seams.hpp"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

namespace taut::renderer {

namespace {

constexpr float sharp_cosine = 0.6428F;  // of 50 degrees
// Coordinates that differ by less were written with few digits.
constexpr float same_coordinate = 1e-5F;

bool differ(const glm::vec2& a, const glm::vec2& b) {
  return std::abs(a.x - b.x) > same_coordinate || std::abs(a.y - b.y) > same_coordinate;
}

}  // namespace

std::vector<VertexPair> seam_edges(std::span<const glm::vec3> rest_positions,
                                   std::span<const std::uint32_t> triangles,
                                   std::span<const glm::vec2> corner_coordinates) {
  assert(corner_coordinates.empty() || corner_coordinates.size() == triangles.size());
  const auto normal = [&](std::uint32_t side) {
    const std::uint32_t* corners = &triangles[side - side % 3];
    const glm::vec3& a = rest_positions[corners[0]];
    return glm::cross(rest_positions[corners[1]] - a, rest_positions[corners[2]] - a);
  };
  const auto is_sharp = [&](std::uint32_t one, std::uint32_t other) {
    const glm::vec3 a = normal(one), b = normal(other);
    return glm::dot(a, b) < sharp_cosine * std::sqrt(glm::dot(a, a) * glm::dot(b, b));
  };
  const auto is_cut = [&](std::uint32_t one, std::uint32_t other) {
    const bool same_way = triangles[one] == triangles[other];
    const std::uint32_t start = same_way ? other : next_corner(other);
    const std::uint32_t end = same_way ? next_corner(other) : other;
    return differ(corner_coordinates[one], corner_coordinates[start]) ||
           differ(corner_coordinates[next_corner(one)], corner_coordinates[end]);
  };
  const std::vector<TriangleSide> sides = sorted_sides(triangles);
  std::vector<VertexPair> seams;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const std::uint32_t one = sides[i].number, other = sides[i + 1].number;
    if (sides[i].ends != sides[i + 1].ends || (!seams.empty() && seams.back() == sides[i].ends)) continue;
    if (corner_coordinates.empty() ? is_sharp(one, other) : is_cut(one, other))
      seams.push_back(sides[i].ends);
  }
  return seams;
}

}  // namespace taut::renderer
