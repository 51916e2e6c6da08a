#pragma once

#include "sim/solvers/ideal.hpp"

namespace taut::sim {

struct ProvotSettings {
  SpringStiffness stiffness = {};
  double max_stretch = 0.05;  ///< the threshold above which a spring is pulled back

  bool operator==(const ProvotSettings&) const = default;
};

/// The threshold method the paper argues with (Provot 1995): springs obey Hooke, and after each step every
/// structural or shear spring that is longer than the threshold allows is pulled back to just that length,
/// once, in spring order. Springs below the threshold are left to their forces, and a spring corrected early
/// may be stretched again by one that follows.
class ProvotThreshold : public IdealSprings {
 public:
  explicit ProvotThreshold(const ProvotSettings& settings)
      : IdealSprings({settings.stiffness}), max_stretch_(settings.max_stretch) {}

  void compensate(const Garment& garment, const Pins& pins, State& state) const override;

 private:
  double max_stretch_;
};

}  // namespace taut::sim
