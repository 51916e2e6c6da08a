#pragma once

#include "sim/step.hpp"

namespace taut::sim {

/// The stiffness of springs per kind, and the damping of every spring.
struct SpringStiffness {
  double structural_n_per_m = 200.0;
  double shear_n_per_m = 100.0;
  double flexural_n_per_m = 5.0;
  double damping_n_s_per_m = 0.02;

  bool operator==(const SpringStiffness&) const = default;
};

/// The settings of `ideal`.
struct IdealSettings {
  SpringStiffness stiffness = {};

  bool operator==(const IdealSettings&) const = default;
};

/// Returns the stiffness of springs of that kind, in N/m.
double stiffness_of(SpringKind kind, const SpringStiffness& stiffness);

/// The ideal mass-spring model: elongation in proportion to stress (Hooke) and no constraint, so that the
/// cloth over-stretches (section III of the paper). It is explicit and therefore stable in short steps only;
/// see stable_time_step_s.
class IdealSprings : public SpringResponse {
 public:
  explicit IdealSprings(const IdealSettings& settings) : stiffness_(settings.stiffness) {}

  void add_spring_forces(const Garment& garment, const State& state, std::span<Vec3> forces_n) const override;
  void compensate(const Garment&, const Pins&, State&) const override {}

 private:
  SpringStiffness stiffness_;
};

}  // namespace taut::sim
