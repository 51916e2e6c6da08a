#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "sim/mesh/types.hpp"
#include "sim/springs.hpp"

namespace taut::sim {

/// How much of its error each spring corrects when its turn comes. All 1: the paper's rigid springs.
struct Rigidity {
  /// Of springs that are too short, structural and shear. Below 1 lets a triangle mesh fold and shear,
  /// which rigid triangles cannot; 0 makes the springs strings.
  double compression = 1.0;
  /// Of flexural springs, both ways. Rigid flexural springs make cloth a plate.
  double flexural = 1.0;

  bool operator==(const Rigidity&) const = default;
};

/// Eq. (3) for the spring with the vector L' = p'_i - p'_j of the given length: shortens it by `error_m`
/// (negative: lengthens it), the lighter end moving more. A spring with both ends pinned, or without a
/// direction because its ends coincide, is left alone.
inline void compensate_spring(const Edge& ends, const Vec3& spring, double length_m, double error_m,
                              std::span<const double> inverse_masses_per_kg, std::span<Vec3> predicted) {
  const auto [i, j] = ends;
  const double w_i = inverse_masses_per_kg[i];
  const double w_j = inverse_masses_per_kg[j];
  if (!(w_i + w_j > 0.0) || !(length_m > 0.0)) {
    return;
  }
  const Vec3 correction = spring * (error_m / (length_m * (w_i + w_j)));
  predicted[i] -= w_i * correction;
  predicted[j] += w_j * correction;
}

/// Eqs. (2)-(3), one sweep over all springs in their order: with L' = p'_i - p'_j and w the inverse masses,
///   dp_i = -w_i / (w_i + w_j) (|L'| - |L|) L' / |L'|,   dp_j = +w_j / (w_i + w_j) (|L'| - |L|) L' / |L'|,
/// which is the paper's one half where both masses are equal. Every correction is seen by the springs that
/// follow.
void compensate_springs(const Springs& springs, std::span<const double> inverse_masses_per_kg,
                        const Rigidity& rigidity, std::span<Vec3> predicted);

}  // namespace taut::sim
