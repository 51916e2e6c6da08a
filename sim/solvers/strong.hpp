#pragma once

#include "sim/step.hpp"
#include "sim/strong_constraint.hpp"

namespace taut::sim {

struct StrongSettings {
  int iterations = 4;  ///< sweeps of the constraint in every time step
  Rigidity rigidity = {};

  bool operator==(const StrongSettings&) const = default;
};

/// The paper, literally: springs exert no force; after each prediction k sweeps of the strong constraint
/// over all springs, in their order.
class StrongConstraint : public SpringResponse {
 public:
  explicit StrongConstraint(const StrongSettings& settings) : settings_(settings) {}

  void add_spring_forces(const Garment&, const State&, std::span<Vec3>) const override {}
  void compensate(const Garment& garment, const Pins& pins, State& state) const override;

 private:
  StrongSettings settings_;
};

}  // namespace taut::sim
