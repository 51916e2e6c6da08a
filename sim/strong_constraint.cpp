#include "sim/strong_constraint.hpp"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

namespace taut::sim {
namespace {

struct Share {
  double when_long;
  double when_short;
};

Share share_of(SpringKind kind, const Rigidity& rigidity) {
  if (kind == SpringKind::flexural) {
    return {rigidity.flexural, rigidity.flexural};
  }
  return {1.0, rigidity.compression};
}

}  // namespace

void compensate_springs(const Springs& springs, std::span<const double> inverse_masses_per_kg,
                        const Rigidity& rigidity, std::span<Vec3> predicted) {
  assert(inverse_masses_per_kg.size() == predicted.size());
  for (const SpringKind kind : all_spring_kinds) {
    const Share share = share_of(kind, rigidity);
    for (std::size_t s = springs.begin_of(kind); s < springs.end_of(kind); ++s) {
      const auto [i, j] = springs.ends[s];
      const Vec3 spring = predicted[i] - predicted[j];
      const double length_m = glm::length(spring);
      const double error_m = length_m - springs.rest_lengths_m[s];
      const double fraction = error_m > 0.0 ? share.when_long : share.when_short;
      compensate_spring(springs.ends[s], spring, length_m, fraction * error_m, inverse_masses_per_kg,
                        predicted);
    }
  }
}

}  // namespace taut::sim
