#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "sim/mesh/types.hpp"
#include "sim/springs.hpp"

namespace taut::sim {

/// The fraction of its length error that a spring corrects in one sweep, 0 to 1. With both at 1 the springs
/// are rigid, as in the paper.
struct Rigidity {
  /// For structural and shear springs that are too short. Below 1 a triangle mesh can fold and shear, which
  /// rigid triangles cannot. At 0 the springs act as strings.
  double compression = 1.0;
  /// For flexural springs, too long or too short. At 1 the cloth is as stiff as a plate.
  double flexural = 1.0;

  bool operator==(const Rigidity&) const = default;
};

/// Eq. (3) for one spring. `spring` is L' = p'_i - p'_j in metres and `length_m` its length. Shortens the
/// spring by `error_m`, or lengthens it if that is negative. The lighter end moves more. Does nothing if both
/// ends are pinned or at the same point. The spans have one entry per vertex.
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

/// Eqs. (2) and (3): one sweep over all springs in their order. With L' = p'_i - p'_j and the inverse masses
/// w:
///   dp_i = -w_i / (w_i + w_j) (|L'| - |L|) L' / |L'|,   dp_j = +w_j / (w_i + w_j) (|L'| - |L|) L' / |L'|.
/// For equal masses the factor is the paper's one half. Each correction is seen by the springs that follow.
/// The spans have one entry per vertex; positions are in metres.
void compensate_springs(const Springs& springs, std::span<const double> inverse_masses_per_kg,
                        const Rigidity& rigidity, std::span<Vec3> predicted);

}  // namespace taut::sim
