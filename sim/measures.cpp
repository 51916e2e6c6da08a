#include "sim/measures.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace taut::sim {
namespace {

double stretch_of(const Springs& springs, std::size_t s, std::span<const Vec3> positions) {
  const auto [i, j] = springs.ends[s];
  return glm::length(positions[i] - positions[j]) / springs.rest_lengths_m[s] - 1.0;
}

}  // namespace

Stretch measure_stretch(const Springs& springs, std::span<const Vec3> positions) {
  if (springs.structural_count == 0) {
    return {};
  }
  std::vector<double> stretches(springs.structural_count);
  double sum = 0.0;
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    stretches[s] = stretch_of(springs, s, positions);
    sum += stretches[s];
  }
  const auto [smallest, largest] = std::minmax_element(stretches.begin(), stretches.end());
  Stretch result;
  result.max = *largest;
  result.mean = sum / static_cast<double>(stretches.size());
  result.max_compression = std::max(0.0, -*smallest);
  // The nearest rank: of the springs, 99 of 100 are at or below it.
  const auto rank = stretches.begin() + static_cast<std::ptrdiff_t>((99 * stretches.size() + 99) / 100 - 1);
  std::nth_element(stretches.begin(), rank, stretches.end());
  result.p99 = *rank;
  return result;
}

std::vector<double> vertex_stretch(const Springs& springs, std::span<const Vec3> positions) {
  std::vector<double> stretch(positions.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t s = 0; s < springs.structural_count; ++s) {
    const double value = stretch_of(springs, s, positions);
    for (const Index v : springs.ends[s]) {
      stretch[v] = std::max(stretch[v], value);
    }
  }
  std::replace(stretch.begin(), stretch.end(), -std::numeric_limits<double>::infinity(), 0.0);
  return stretch;
}

double convergence_of(const ShapeChange& change, Index vertex) {
  return glm::length(change.now[vertex] - change.before[vertex]);
}

Convergence measure_convergence(const ShapeChange& change) {
  assert(change.before.size() == change.now.size());
  Convergence result;
  double sum_of_squares = 0.0;
  for (std::size_t v = 0; v < change.now.size(); ++v) {
    const double moved_m = convergence_of(change, static_cast<Index>(v));
    result.max_m = std::max(result.max_m, moved_m);
    sum_of_squares += moved_m * moved_m;
  }
  if (!change.now.empty()) {
    result.rms_m = std::sqrt(sum_of_squares / static_cast<double>(change.now.size()));
  }
  return result;
}

double rms_speed(const ShapeChange& change) {
  return measure_convergence(change).rms_m / change.time_s;
}

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
  const auto is_near = [](double coordinate_m) { return std::abs(coordinate_m) <= lost_at_m; };
  std::size_t v = 0;
  while (v < positions.size() && is_near(positions[v].x) && is_near(positions[v].y) &&
         is_near(positions[v].z)) {
    ++v;
  }
  return v;
}

}  // namespace taut::sim
