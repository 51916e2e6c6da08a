#pragma once

#include "sim/step.hpp"

namespace taut::sim {

/// Of springs in N/m, by kind, and the damping of every spring in N s/m.
struct SpringStiffness {
  double structural_n_per_m = 200.0;
  double shear_n_per_m = 100.0;
  double flexural_n_per_m = 5.0;
  double damping_n_s_per_m = 0.02;

  bool operator==(const SpringStiffness&) const = default;
};

struct IdealSettings {
  SpringStiffness stiffness = {};

  bool operator==(const IdealSettings&) const = default;
};

double stiffness_of(SpringKind kind, const SpringStiffness& stiffness);

/// The ideal mass-spring model: elongation in proportion to stress (Hooke) and no constraint, so that cloth
/// over-stretches (section III of the paper). Explicit: stable in short steps alone, see stable_time_step_s.
class IdealSprings : public SpringResponse {
 public:
  explicit IdealSprings(const IdealSettings& settings) : stiffness_(settings.stiffness) {}

  void add_spring_forces(const Garment& garment, const State& state, std::span<Vec3> forces_n) const override;
  void compensate(const Garment&, const Pins&, State&) const override {}

 private:
  SpringStiffness stiffness_;
};

}  // namespace taut::sim
