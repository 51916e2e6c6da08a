#pragma once

#include "sim/solvers/ideal.hpp"

namespace taut::sim {

/// The threshold method the paper argues with (Provot 1995): springs obey Hooke, and after each step every
/// structural or shear spring that is longer than the threshold allows is pulled back to just that length,
/// once, in spring order. Springs below the threshold are left to their forces, and a spring corrected early
/// may be stretched again by one that follows.
class ProvotThreshold : public IdealSprings {
 public:
  ProvotThreshold(const SpringStiffness& stiffness, double largest_stretch)
      : IdealSprings(stiffness), largest_stretch_(largest_stretch) {}

  void compensate(const Garment& garment, State& state) const override;

 private:
  double largest_stretch_;
};

}  // namespace taut::sim
