#pragma once

#include "sim/step.hpp"
#include "sim/strong_constraint.hpp"

namespace taut::sim {

/// The paper, literally: springs exert no force; after each prediction k sweeps of the strong constraint
/// over all springs, in their order.
class StrongConstraint : public SpringResponse {
 public:
  StrongConstraint(int iterations, const Rigidity& rigidity) : iterations_(iterations), rigidity_(rigidity) {}

  void add_spring_forces(const Garment&, const State&, std::span<Vec3>) const override {}
  void compensate(const Garment& garment, State& state) const override;

 private:
  int iterations_;
  Rigidity rigidity_;
};

}  // namespace taut::sim
