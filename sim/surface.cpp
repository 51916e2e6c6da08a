#include "sim/surface.hpp"

#include "sim/mesh/preconditions.hpp"

namespace taut::sim {
namespace {

/// Smallest height of a triangle with a surface, as a fraction of its longest edge.
constexpr double min_height_ratio = 1e-3;

/// Smallest |y| of the unit normal of a triangle that lies flat.
constexpr double max_upright_cosine = 0.99;

TriangleAtRest lay_flat(const std::array<Vec3, 3>& corners) {
  const Vec3 e1 = corners[1] - corners[0];
  const Vec3 e2 = corners[2] - corners[0];
  const double base_m = glm::length(e1);
  const double max_length_m = std::max({base_m, glm::length(e2), glm::distance(corners[1], corners[2])});
  const double doubled_area_m2 = glm::length(glm::cross(e1, e2));
  if (!(doubled_area_m2 >= min_height_ratio * max_length_m * max_length_m && base_m > 0.0)) return {};
  TriangleAtRest rest;
  rest.along_per_m = 1.0 / base_m;
  rest.across_per_m = base_m / doubled_area_m2;
  rest.skew_per_m = glm::dot(e1, e2) / (base_m * doubled_area_m2);
  return rest;
}

}  // namespace

double min_height_m(const TriangleAtRest& rest) {
  const double base_m = 1.0 / rest.along_per_m;
  const double height_m = 1.0 / rest.across_per_m;
  const double foot_m = rest.skew_per_m * base_m * height_m;
  const double longest_squared_m2 = std::max({base_m * base_m, foot_m * foot_m + height_m * height_m,
                                              (base_m - foot_m) * (base_m - foot_m) + height_m * height_m});
  return base_m * height_m / std::sqrt(longest_squared_m2);
}

std::array<Vec2, 3> gradients_by_corners(const TriangleAtRest& rest) {
  const auto [along, across, skew] = rest;
  return {Vec2(-along, skew - across), Vec2(along, -skew), Vec2(0.0, across)};
}

std::vector<TriangleAtRest> triangles_at_rest(const Mesh& mesh) {
  assert(are_below(mesh.triangles, mesh.positions.size()));
  std::vector<TriangleAtRest> rest;
  rest.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) rest.push_back(lay_flat(corners_at_rest(mesh, t)));
  return rest;
}

DeformationGradient deformation_gradient(const TriangleAtRest& rest, const std::array<Vec3, 3>& corners) {
  const Vec3 e1 = corners[1] - corners[0];
  const Vec3 e2 = corners[2] - corners[0];
  return {rest.along_per_m * e1, rest.across_per_m * e2 - rest.skew_per_m * e1};
}

PrincipalStretches principal_stretches(const DeformationGradient& gradient) {
  const double a = glm::dot(gradient.along, gradient.along);
  const double b = glm::dot(gradient.along, gradient.across);
  const double c = glm::dot(gradient.across, gradient.across);
  const double mean = (a + c) / 2.0;
  const double half = (a - c) / 2.0;
  const double radius = std::sqrt(half * half + b * b);
  return {std::sqrt(mean + radius), std::sqrt(std::max(0.0, mean - radius))};
}

Vec2 principal_direction(const DeformationGradient& gradient) {
  const double product = glm::dot(gradient.along, gradient.across);
  const double half = (glm::dot(gradient.along, gradient.along) - glm::dot(gradient.across, gradient.across)) / 2.0;
  const double larger_component = std::sqrt(half * half + product * product) + std::abs(half);
  if (!(larger_component > 0.0)) return {1.0, 0.0};
  return glm::normalize(half >= 0.0 ? Vec2(larger_component, product) : Vec2(product, larger_component));
}

Vec2 upright_direction(const std::array<Vec3, 3>& corners) {
  const Vec3 first = glm::normalize(corners[1] - corners[0]);
  const Vec3 normal = glm::normalize(glm::cross(first, corners[2] - corners[0]));
  const Vec3 second = glm::cross(normal, first);
  const Vec3 up = std::abs(normal.y) < max_upright_cosine ? Vec3(0.0, 1.0, 0.0) : Vec3(0.0, 0.0, 1.0);
  return glm::normalize(Vec2(glm::dot(up, first), glm::dot(up, second)));
}

std::vector<Vec2> warps_from_coordinates(const Mesh& mesh, std::span<const glm::vec2> corner_coordinates) {
  assert(corner_coordinates.size() == 3 * mesh.triangles.size());
  std::vector<Vec2> warps;
  warps.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<Vec3, 3> corners = corners_at_rest(mesh, t);
    const TriangleAtRest rest = lay_flat(corners);
    if (!rest.has_surface()) {
      warps.emplace_back(1.0, 0.0);
      continue;
    }
    const double first = corner_coordinates[3 * t + 1].x - corner_coordinates[3 * t].x;
    const double second = corner_coordinates[3 * t + 2].x - corner_coordinates[3 * t].x;
    const Vec2 across = {rest.along_per_m * first, rest.across_per_m * second - rest.skew_per_m * first};
    const double length = glm::length(across);
    warps.push_back(length > 0.0 ? Vec2(-across.y, across.x) / length : upright_direction(corners));
  }
  return warps;
}

}  // namespace taut::sim
