#pragma once

#include "sim/mesh/types.hpp"
#include "sim/springs.hpp"
#include "sim/step.hpp"

namespace taut::sim {

/// Fraction of its length error that a spring corrects in one sweep, 0 to 1. With both at 1 the springs are rigid, as
/// in the paper.
struct Rigidity {
  /// Fraction for structural and shear springs that are too short. Below 1 a triangle mesh can fold and shear, which
  /// rigid triangles cannot. At 0 the springs act as strings.
  double compression = 1.0;
  /// Fraction for flexural springs, too long or too short. At 1 the cloth is as stiff as a plate.
  double flexural = 1.0;

  bool operator==(const Rigidity&) const = default;
};

/// Eq. (3) for one spring. `spring` is L' = p'_i - p'_j in metres and `length_m` its length. Shortens the spring by
/// `error_m`, or lengthens it if that is negative. The lighter end moves more. Does nothing if both ends are pinned or
/// at one point. The spans have one entry per vertex.
inline void compensate_spring(const Edge& ends, const Vec3& spring, double length_m, double error_m,
                              std::span<const double> inverse_masses_per_kg, std::span<Vec3> predicted) {
  const auto [i, j] = ends;
  const double w_i = inverse_masses_per_kg[i];
  const double w_j = inverse_masses_per_kg[j];
  if (!(w_i + w_j > 0.0) || !(length_m > 0.0)) return;
  const Vec3 correction = spring * (error_m / (length_m * (w_i + w_j)));
  predicted[i] -= w_i * correction;
  predicted[j] += w_j * correction;
}

/// Eqs. (2) and (3): one sweep over all springs in their order. With L' = p'_i - p'_j and the inverse masses
/// w:
///   dp_i = -w_i / (w_i + w_j) (|L'| - |L|) L' / |L'|,   dp_j = +w_j / (w_i + w_j) (|L'| - |L|) L' / |L'|.
/// For equal masses the factor is the paper's one half. Each correction is seen by the springs that follow.
/// The spans have one entry per vertex; positions are in metres.
void compensate_springs(const Springs& springs, std::span<const double> inverse_masses_per_kg, const Rigidity& rigidity,
                        std::span<Vec3> predicted);

/// Stiffness of springs per kind, and the damping of every spring.
struct SpringStiffness {
  double structural_n_per_m = 200.0;
  double shear_n_per_m = 100.0;
  double flexural_n_per_m = 5.0;
  double damping_n_s_per_m = 0.02;

  bool operator==(const SpringStiffness&) const = default;
};

/// Settings of `ideal`.
struct IdealSettings {
  SpringStiffness stiffness = {};

  bool operator==(const IdealSettings&) const = default;
};

/// Returns the stiffness of springs of that kind, in N/m.
double spring_stiffness(SpringKind kind, const SpringStiffness& stiffness);

/// Ideal mass-spring model: elongation in proportion to stress (Hooke) and no constraint, so that the cloth
/// over-stretches (section III of the paper). It is explicit and therefore stable only for short steps; see
/// stable_time_step_s.
class IdealSprings : public SpringResponse {
 public:
  explicit IdealSprings(const IdealSettings& settings) : stiffness_(settings.stiffness) {}

  void add_spring_forces(const Garment& garment, const State& state, std::span<Vec3> forces_n) const override;
  void compensate(const Garment&, const Pins&, State&) const override {}

 private:
  SpringStiffness stiffness_;
};

/// Settings of `strong`.
struct StrongSettings {
  int iterations = 4;  ///< sweeps of the constraint per time step, at least 1
  Rigidity rigidity = {};

  bool operator==(const StrongSettings&) const = default;
};

/// The paper's method to the letter. Springs exert no force. After each prediction, the strong constraint sweeps over
/// all springs in their order, `iterations` times.
class StrongConstraint : public SpringResponse {
 public:
  explicit StrongConstraint(const StrongSettings& settings) : settings_(settings) {}

  void add_spring_forces(const Garment&, const State&, std::span<Vec3>) const override {}
  void compensate(const Garment& garment, const Pins& pins, State& state) const override;

 private:
  StrongSettings settings_;
};

/// Settings of `provot`.
struct ProvotSettings {
  SpringStiffness stiffness = {};
  double max_stretch = 0.05;  ///< threshold; springs stretched more are pulled back to it

  bool operator==(const ProvotSettings&) const = default;
};

/// Threshold method that the paper compares itself with (Provot 1995). Springs obey Hooke's law. After each prediction,
/// every structural or shear spring longer than the threshold is pulled back to exactly that length, once, in spring
/// order. A later spring may stretch a corrected one again. Springs below the threshold are left to their forces.
class ProvotThreshold : public IdealSprings {
 public:
  explicit ProvotThreshold(const ProvotSettings& settings)
      : IdealSprings({settings.stiffness}), max_stretch_(settings.max_stretch) {}

  void compensate(const Garment& garment, const Pins& pins, State& state) const override;

 private:
  double max_stretch_;
};

/// Settings of `vassilev`.
struct VassilevSettings {
  SpringStiffness stiffness = {};
  /// Threshold; springs stretched more may not stretch further. Lower values make tighter cloth that moves less freely.
  /// The paper takes 0.01 to 0.15.
  double max_stretch = 0.05;

  bool operator==(const VassilevSettings&) const = default;
};

/// Velocity directional modification (Vassilev, Spanlang and Chrysanthou 2001): it changes velocities where `provot`
/// changes positions. Springs obey Hooke's law. If a structural or shear spring is longer than the threshold and its
/// ends are about to part further, their velocity components along it become their mean. The mean is weighted by mass,
/// which keeps momentum; for equal masses it is the paper's one half. The velocities include the forces of the step, so
/// pulling forces are balanced too. Only its own force pulls such a spring back, and a later spring may part its ends
/// again.
class VelocityModification : public IdealSprings {
 public:
  explicit VelocityModification(const VassilevSettings& settings)
      : IdealSprings({settings.stiffness}), max_stretch_(settings.max_stretch) {}

  void compensate(const Garment& garment, const Pins& pins, State& state) const override;

 private:
  double max_stretch_;
};

/// Returns the longest time step, in seconds, for which Hooke's springs are stable under Verlet's explicit prediction.
/// Velocities lag by one step. The condition is
///   dt^2 w^2 + 2 c dt < 4,   w^2 <= 2 sum k / m,   c <= 2 sum d / m + air drag
/// with the stiffness k and the damping d of the springs at a vertex (Gershgorin's bound on the eigenvalues). A margin
/// remains for wind and hands; their own formulas limit how much they add. Returns infinity if nothing can oscillate.
double stable_time_step_s(const Garment& garment, const Pins& pins, const SpringStiffness& stiffness,
                          double air_drag_per_s);

}  // namespace taut::sim
