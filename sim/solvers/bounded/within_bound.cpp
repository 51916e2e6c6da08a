#include "sim/solvers/bounded/within_bound.hpp"

#include "sim/mesh/preconditions.hpp"
#include "sim/solvers/bounded/kernels/kernels.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/projection.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim {
namespace {

/// Smallest excess in m that single precision resolves.
constexpr double min_resolved_m = 1e-6;

/// Returns the largest excess length of a spring, in metres; 0 if none exceeds the bound.
double max_spring_excess_m(const Springs& springs, std::span<const Vec3> positions, double max_stretch) {
  assert(are_below(springs.ends, positions.size()));
  assert(max_stretch >= 0.0);
  double max_m = 0.0;
  for (std::size_t s = 0; s < springs.begin_index(SpringKind::flexural); ++s) {
    const double length_m = glm::distance(positions[springs.ends[s][0]], positions[springs.ends[s][1]]);
    const double excess_m = length_m - (1.0 + max_stretch) * springs.rest_lengths_m[s];
    // This form does not skip a length that is not a number.
    max_m = excess_m <= max_m ? max_m : excess_m;
  }
  return max_m;
}

/// Returns the largest excess of a triangle along its smallest height, in metres; 0 if none exceeds the bound.
double max_surface_excess_m(const Garment& garment, std::span<const Vec3> positions, double max_stretch) {
  assert(positions.size() == garment.mesh.positions.size());
  assert(max_stretch >= 0.0);
  double max_m = 0.0;
  for (std::size_t t = 0; t < garment.mesh.triangles.size(); ++t) {
    const TriangleAtRest& rest = garment.triangles_at_rest[t];
    if (rest.has_surface()) {
      const auto corners = corner_positions(garment.mesh.triangles[t], positions);
      const double stretch = principal_stretches(deformation_gradient(rest, corners)).max_ratio - 1.0;
      const double excess_m = (stretch - max_stretch) * min_height_m(rest);
      max_m = excess_m <= max_m ? max_m : excess_m;
    }
  }
  return max_m;
}

/// Does one sweep of eqs. (2) and (3) over the springs that are too long.
void shorten_springs(const Garment& garment, const Pins& pins, double max_stretch, std::span<Vec3> positions) {
  const Springs& springs = garment.springs;
  for (std::size_t s = 0; s < springs.begin_index(SpringKind::flexural); ++s) {
    const auto [i, j] = springs.ends[s];
    const Vec3 spring = positions[i] - positions[j];
    const double length_m = glm::length(spring);
    const double w_i = pins.inverse_masses_per_kg[i];
    const double w_j = pins.inverse_masses_per_kg[j];
    if (length_m > (1.0 + max_stretch) * springs.rest_lengths_m[s] && w_i + w_j > 0.0) {
      const double aim_m = (1.0 + bounded::tuning::aim_fraction * max_stretch) * springs.rest_lengths_m[s];
      const Vec3 correction = spring * ((length_m - aim_m) / length_m / (w_i + w_j));
      positions[i] -= w_i * correction;
      positions[j] += w_j * correction;
    }
  }
}

/// Projects one triangle, like the kernels (kernels.hpp), onto the shapes with the largest singular value `aim`.
void shorten_triangle(const TriangleAtRest& rest, const Triangle& t, const Pins& pins, double aim,
                      std::span<Vec3> positions) {
  assert(are_below(std::span(&t, 1), positions.size()));
  const DeformationGradient gradient = deformation_gradient(rest, corner_positions(t, positions));
  const Vec2 v = principal_direction(gradient);
  const Vec3 stretched = v.x * gradient.along + v.y * gradient.across;
  const double length = glm::length(stretched);
  const std::array<Vec2, 3> columns = gradients_by_corners(rest);
  std::array<double, 3> gradients{};
  double divisor = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double w = pins.inverse_masses_per_kg[t[k]];
    gradients[k] = glm::dot(columns[k], v);
    divisor += w * (gradients[k] * gradients[k] + bounded::min_mobility * glm::dot(columns[k], columns[k]));
  }
  if (divisor > 0.0) {
    const Vec3 correction = stretched * ((length - aim) / length / divisor);
    for (std::size_t k = 0; k < 3; ++k) {
      positions[t[k]] -= pins.inverse_masses_per_kg[t[k]] * gradients[k] * correction;
    }
  }
}

void shorten_surface(const Garment& garment, const Pins& pins, double max_stretch, std::span<Vec3> positions) {
  for (std::size_t t = 0; t < garment.mesh.triangles.size(); ++t) {
    const TriangleAtRest& rest = garment.triangles_at_rest[t];
    const Triangle& triangle = garment.mesh.triangles[t];
    if (rest.has_surface() &&
        principal_stretches(deformation_gradient(rest, corner_positions(triangle, positions))).max_ratio >
            1.0 + max_stretch) {
      shorten_triangle(rest, triangle, pins, 1.0 + bounded::tuning::aim_fraction * max_stretch, positions);
    }
  }
}

}  // namespace

double max_excess_m(const Garment& garment, const BoundedSettings& settings, std::span<const Vec3> positions) {
  const double springs_m = max_spring_excess_m(garment.springs, positions, settings.max_stretch);
  return settings.bound == BoundKind::springs
             ? springs_m
             : std::max(springs_m, max_surface_excess_m(garment, positions, settings.max_stretch));
}

void shorten_once(const Garment& garment, const Pins& pins, const BoundedSettings& settings,
                  std::span<Vec3> positions) {
  shorten_springs(garment, pins, settings.max_stretch, positions);
  if (settings.bound == BoundKind::surface) shorten_surface(garment, pins, settings.max_stretch, positions);
}

void move_within_bound(const Garment& garment, const Pins& pins, const BoundedSettings& settings, State& state) {
  if (max_excess_m(garment, settings, state.current) == 0.0) return;
  bounded::Layout layout = bounded::make_layout(garment, pins, settings.bound);
  bounded::ParallelKernels kernels(bounded::kernels_for(settings.vector_unit), 1);
  bounded::StartRows start;
  bounded::set_start(layout, state.current, start);
  kernels.start(start, layout.springs);
  kernels.start(start, layout.surface);
  bounded::BoundProjection projection(layout, 0.0);
  bounded::Float4Array corrections(layout.row_count());
  projection.project(layout, bounded::Float4Array(layout.row_count()), settings.max_stretch,
                     {bounded::tuning::last_resort_sweeps}, nullptr, kernels, corrections);
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    const Vec3 moved = bounded::to_vec3(projection.corrected()[row]);
    state.current[layout.vertex_indices[row]] += moved;
    state.previous[layout.vertex_indices[row]] += moved;
  }
}

bool keeps_bound_in_double(const Garment& garment, const Pins& pins, const BoundedSettings& settings,
                           std::span<Vec3> positions, const AllowPosition& allow) {
  assert(positions.size() == garment.mesh.positions.size());
  double excess_m = max_excess_m(garment, settings, positions);
  const std::vector<Vec3> before_m(positions.begin(), positions.end());
  for (int sweep = 0; sweep < bounded::tuning::last_resort_sweeps && excess_m > 0.0 && excess_m < min_resolved_m;
       ++sweep) {
    shorten_once(garment, pins, settings, positions);
    excess_m = max_excess_m(garment, settings, positions);
  }
  for (Index v = 0; v < before_m.size(); ++v) {
    if (allow && positions[v] != before_m[v] && !allow(v, positions[v])) positions[v] = before_m[v];
  }
  return max_excess_m(garment, settings, positions) == 0.0;
}

}  // namespace taut::sim
