#pragma once

#include "sim/solvers/ideal.hpp"

namespace taut::sim {

/// The settings of `provot`.
struct ProvotSettings {
  SpringStiffness stiffness = {};
  double max_stretch = 0.05;  ///< the threshold; a spring stretched more is pulled back to it

  bool operator==(const ProvotSettings&) const = default;
};

/// The threshold method that the paper compares itself with (Provot 1995). Springs obey Hooke's law. After
/// each prediction, every structural or shear spring that is longer than the threshold allows is pulled back
/// to exactly that length, once, in spring order. Springs below the threshold are left to their forces. A
/// spring that follows may stretch a corrected one again.
class ProvotThreshold : public IdealSprings {
 public:
  explicit ProvotThreshold(const ProvotSettings& settings)
      : IdealSprings({settings.stiffness}), max_stretch_(settings.max_stretch) {}

  void compensate(const Garment& garment, const Pins& pins, State& state) const override;

 private:
  double max_stretch_;
};

}  // namespace taut::sim
