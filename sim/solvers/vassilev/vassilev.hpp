#pragma once

#include "sim/solvers/ideal.hpp"

namespace taut::sim {

/// The settings of `vassilev`.
struct VassilevSettings {
  SpringStiffness stiffness = {};
  /// The threshold. Springs stretched more may not stretch further; less makes tighter cloth that moves
  /// less freely. The paper takes 0.01 to 0.15.
  double max_stretch = 0.05;

  bool operator==(const VassilevSettings&) const = default;
};

/// Velocities are changed where `provot` changes positions (Vassilev, Spanlang and Chrysanthou 2001, velocity
/// directional modification). Springs obey Hooke's law. A structural or shear spring that is longer than the
/// threshold allows, and whose ends are about to part further, has the components of their velocities along
/// it set to their common mean. Masses weigh it, so that momentum is kept; where they are equal it is the
/// paper's one half. The velocities are those that the forces of the step lead to: what pulls the ends apart
/// is balanced too. Nothing pulls such a spring back but its own force, and a spring that follows in the
/// order may part its ends again.
class VelocityModification : public IdealSprings {
 public:
  explicit VelocityModification(const VassilevSettings& settings)
      : IdealSprings({settings.stiffness}), max_stretch_(settings.max_stretch) {}

  void compensate(const Garment& garment, const Pins& pins, State& state) const override;

 private:
  double max_stretch_;
};

}  // namespace taut::sim
