#include "sim/measures.hpp"

#include "sim/mesh/preconditions.hpp"

namespace taut::sim {
namespace {

double spring_stretch(const Springs& springs, std::size_t s, std::span<const Vec3> positions) {
  assert(s < springs.ends.size());
  assert(springs.ends[s][1] < positions.size());
  const auto [i, j] = springs.ends[s];
  return glm::length(positions[i] - positions[j]) / springs.rest_lengths_m[s] - 1.0;
}

double triangle_stretch(const Garment& garment, std::size_t t, std::span<const Vec3> positions) {
  assert(t < garment.mesh.triangles.size());
  assert(positions.size() == garment.mesh.positions.size());
  const auto corners = corner_positions(garment.mesh.triangles[t], positions);
  return principal_stretches(deformation_gradient(garment.triangles_at_rest[t], corners)).max_ratio - 1.0;
}

/// Returns the nearest-rank percentile: the smallest value that at least 99 % of the values do not exceed. Requires a
/// value. Changes their order.
double percentile_99(std::vector<double>& values) {
  const auto rank = values.begin() + static_cast<std::ptrdiff_t>((99 * values.size() + 99) / 100 - 1);
  std::nth_element(values.begin(), rank, values.end());
  return *rank;
}

constexpr double none = -std::numeric_limits<double>::infinity();

}  // namespace

Stretch measure_stretch(const Springs& springs, std::span<const Vec3> positions) {
  assert(are_below(springs.ends, positions.size()));
  assert(springs.ends.size() == springs.rest_lengths_m.size());
  if (springs.structural_count == 0) return {};
  std::vector<double> stretches(springs.structural_count);
  double sum = 0.0;
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    stretches[s] = spring_stretch(springs, s, positions);
    sum += stretches[s];
  }
  const auto [smallest, largest] = std::minmax_element(stretches.begin(), stretches.end());
  Stretch result;
  result.max = *largest;
  result.mean = sum / static_cast<double>(stretches.size());
  result.max_compression = std::max(0.0, -*smallest);
  result.p99 = percentile_99(stretches);
  return result;
}

std::vector<double> vertex_stretch(const Springs& springs, std::span<const Vec3> positions) {
  assert(are_below(springs.ends, positions.size()));
  std::vector<double> stretch(positions.size(), none);
  for (std::size_t s = 0; s < springs.structural_count; ++s) {
    const double value = spring_stretch(springs, s, positions);
    for (const Index v : springs.ends[s]) stretch[v] = std::max(stretch[v], value);
  }
  std::replace(stretch.begin(), stretch.end(), none, 0.0);
  return stretch;
}

SurfaceStretch measure_surface_stretch(const Garment& garment, std::span<const Vec3> positions) {
  assert(positions.size() == garment.mesh.positions.size());
  std::vector<double> stretches;
  stretches.reserve(garment.mesh.triangles.size());
  for (std::size_t t = 0; t < garment.mesh.triangles.size(); ++t) {
    if (garment.triangles_at_rest[t].has_surface()) {
      stretches.push_back(triangle_stretch(garment, t, positions));
    }
  }
  if (stretches.empty()) return {};
  const double max_stretch = *std::max_element(stretches.begin(), stretches.end());
  return {max_stretch, percentile_99(stretches)};
}

std::vector<double> triangle_surface_stretch(const Garment& garment, std::span<const Vec3> positions) {
  assert(positions.size() == garment.mesh.positions.size());
  std::vector<double> stretch(garment.mesh.triangles.size(), none);
  for (std::size_t t = 0; t < stretch.size(); ++t) {
    if (garment.triangles_at_rest[t].has_surface()) stretch[t] = triangle_stretch(garment, t, positions);
  }
  std::replace(stretch.begin(), stretch.end(), none, 0.0);
  return stretch;
}

std::vector<double> vertex_surface_stretch(const Garment& garment, std::span<const Vec3> positions) {
  assert(positions.size() == garment.mesh.positions.size());
  std::vector<double> stretch(positions.size(), none);
  for (std::size_t t = 0; t < garment.mesh.triangles.size(); ++t) {
    if (garment.triangles_at_rest[t].has_surface()) {
      const double value = triangle_stretch(garment, t, positions);
      for (const Index v : garment.mesh.triangles[t]) stretch[v] = std::max(stretch[v], value);
    }
  }
  std::replace(stretch.begin(), stretch.end(), none, 0.0);
  return stretch;
}

double vertex_convergence_m(const ShapeChange& change, Index vertex) {
  assert(vertex < change.now.size());
  assert(change.before.size() == change.now.size());
  return glm::length(change.now[vertex] - change.before[vertex]);
}

Convergence measure_convergence(const ShapeChange& change) {
  assert(change.before.size() == change.now.size());
  Convergence result;
  double sum_of_squares = 0.0;
  for (std::size_t v = 0; v < change.now.size(); ++v) {
    const double moved_m = vertex_convergence_m(change, static_cast<Index>(v));
    result.max_m = std::max(result.max_m, moved_m);
    sum_of_squares += moved_m * moved_m;
  }
  if (!change.now.empty()) result.rms_m = std::sqrt(sum_of_squares / static_cast<double>(change.now.size()));
  return result;
}

double rms_speed(const ShapeChange& change) { return measure_convergence(change).rms_m / change.time_s; }

Energy measure_energy(const Garment& garment, const ShapeChange& change, const Vec3& gravity_m_per_s2) {
  assert(change.before.size() == change.now.size() && change.time_s > 0.0);
  Energy energy;
  for (std::size_t v = 0; v < change.now.size(); ++v) {
    const Vec3 velocity_m_per_s = (change.now[v] - change.before[v]) / change.time_s;
    energy.kinetic_j += 0.5 * garment.masses_kg[v] * glm::dot(velocity_m_per_s, velocity_m_per_s);
    energy.potential_j -= garment.masses_kg[v] * glm::dot(gravity_m_per_s2, change.now[v]);
  }
  return energy;
}

std::size_t first_lost(std::span<const Vec3> positions) {
  const auto is_near = [](double coordinate_m) { return std::abs(coordinate_m) <= max_coordinate_m; };
  std::size_t v = 0;
  while (v < positions.size() && is_near(positions[v].x) && is_near(positions[v].y) && is_near(positions[v].z)) {
    ++v;
  }
  return v;
}

}  // namespace taut::sim
