#pragma once

#include "sim/step.hpp"
#include "sim/strong_constraint.hpp"

namespace taut::sim {

/// The settings of `strong`.
struct StrongSettings {
  int iterations = 4;  ///< sweeps of the constraint per time step, at least 1
  Rigidity rigidity = {};

  bool operator==(const StrongSettings&) const = default;
};

/// The paper, literally. Springs exert no force. After each prediction, the strong constraint sweeps over all
/// springs in their order, `iterations` times.
class StrongConstraint : public SpringResponse {
 public:
  explicit StrongConstraint(const StrongSettings& settings) : settings_(settings) {}

  void add_spring_forces(const Garment&, const State&, std::span<Vec3>) const override {}
  void compensate(const Garment& garment, const Pins& pins, State& state) const override;

 private:
  StrongSettings settings_;
};

}  // namespace taut::sim
