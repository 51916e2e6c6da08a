#pragma once

#include <vector>

#include "sim/contact/colliders.hpp"

namespace taut::tailor {

/// Where the wearer stands: feet on y = 0 at the origin, facing +z, the left hand towards +x. The lengths are
/// cisMaleAdult40's, for whom the pattern was drafted.
struct Stance {
  /// Of the point where neck and shoulder meet, which is y = 0 on the pattern: waist to floor 1.184 m, and
  /// the height of the 0.48 m along the trunk above it.
  double neck_point_height_m = 1.65;
  double shoulder_slope = 0.2309;  ///< fall over run: tan 13 degrees
  /// Along the left arm, from the shoulder down and out, of length 1: 43 degrees below the horizontal, the
  /// angle at which the cap of this sleeve meets its armhole without a pull.
  sim::Vec3 left_arm = {0.7313537, -0.6819984, 0.0};
};

/// The wearer as capsules: trunk, shoulders, neck and arms. Not quite as measured: arms and shoulders are
/// thinner (upper arm 0.31 m round, measured 0.37), because a shirt has to be loose to take up its shape
/// without being stretched; chest and waist are fuller (1.10 and 1.01 m, measured 1.05 and 0.85), because
/// cloth with too much ease stands off in a ridge where no gravity pulls it down.
std::vector<sim::Collider> body_colliders(const Stance& stance);

}  // namespace taut::tailor
