#include "app/verify/stretch.hpp"

namespace taut::app {
namespace {

constexpr double min_surface_height_ratio = 1e-3;

/// Coefficients E, F and G of a triangle's first fundamental form, in m^2.
struct FundamentalForm {
  double e, f, g;

  double determinant() const { return e * g - f * f; }
};

struct Sides {
  double first_m, second_m, across_m;  ///< two sides from one corner, and the side across

  double max_length_m() const { return std::max({first_m, second_m, across_m}); }
  FundamentalForm form() const {
    const double e = first_m * first_m, g = second_m * second_m;
    return {e, 0.5 * (e + g - across_m * across_m), g};
  }
};

Sides triangle_sides(const std::array<sim::Vec3, 3>& p) {
  return {glm::distance(p[0], p[1]), glm::distance(p[0], p[2]), glm::distance(p[1], p[2])};
}

/// Returns the square root of the larger root x of det(now - x rest) = 0, minus 1. The radicand of the quadratic
/// formula is written as a sum of squares, which does not cancel where both roots are alike.
double surface_stretch(const FundamentalForm& rest, const FundamentalForm& now) {
  const double determinant = rest.determinant();
  const double p = rest.e * now.f - rest.f * now.e, r = rest.e * now.g - rest.g * now.e;
  const double trace = rest.e * now.g - 2.0 * rest.f * now.f + rest.g * now.e;
  const double root = glm::length(glm::dvec2(r - 2.0 * p * rest.f / rest.e, 2.0 * p * std::sqrt(determinant) / rest.e));
  return std::sqrt((trace + root) / (2.0 * determinant)) - 1.0;
}

bool has_surface(const Sides& rest) {
  const double max_length_m = rest.max_length_m();
  return std::sqrt(rest.form().determinant()) >= min_surface_height_ratio * max_length_m * max_length_m;
}

}  // namespace

LargestStretch largest_stretch(const sim::Mesh& rest, std::span<const sim::Vec3> positions_m) {
  LargestStretch max_stretch;
  const auto add_spring = [&](double rest_m, double now_m) {
    max_stretch.springs = std::max(max_stretch.springs, now_m / rest_m - 1.0);
  };
  for (std::size_t k = 0; k < rest.triangles.size(); ++k) {
    const auto& [a, b, c] = rest.triangles[k];
    const Sides before = triangle_sides(sim::corners_at_rest(rest, k)),
                now = triangle_sides({positions_m[a], positions_m[b], positions_m[c]});
    add_spring(before.first_m, now.first_m);
    add_spring(before.second_m, now.second_m);
    add_spring(before.across_m, now.across_m);
    if (has_surface(before)) {
      max_stretch.surface = std::max(max_stretch.surface, surface_stretch(before.form(), now.form()));
    }
  }
  for (const sim::Quad& q : rest.quads) {
    for (const auto& [a, b] : {sim::Edge{q[0], q[2]}, sim::Edge{q[1], q[3]}}) {
      add_spring(glm::distance(rest.positions[a], rest.positions[b]), glm::distance(positions_m[a], positions_m[b]));
    }
  }
  return max_stretch;
}

}  // namespace taut::app
