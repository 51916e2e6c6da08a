#pragma once

#include <vector>

#include "sim/contact/bodies.hpp"

namespace taut::tailor {

/// How the wearer stands: feet at the origin on y = 0, facing +z, the left hand towards +x. The lengths are
/// those of the measurements cisMaleAdult40; other wearers are the same times `trunk` and `sleeve`.
struct Stance {
  /// Height of the point where neck and shoulder meet, which is y = 0 on the pattern. Waist to floor is 1.184
  /// m; the trunk above it is 0.48 m long.
  double neck_point_height_m = 1.65;
  double shoulder_slope = 0.2309;  ///< drop per horizontal length: tan(13 degrees)
  /// Direction of the left arm from the shoulder, of unit length. It points 43 degrees below the horizontal,
  /// where the cap of this sleeve meets its armhole without strain.
  sim::Vec3 left_arm = {0.7313537, -0.6819984, 0.0};
  double trunk = 1.0;   ///< times as wide and deep as there, and the neck's and shoulders' lengths too
  double sleeve = 1.0;  ///< times as wide a sleeve as there
};

/// The wearer as capsules: trunk, shoulders, neck and arms. Two sizes differ from the measurements. Arms and
/// shoulders are thinner (upper arm 0.31 m around, measured 0.37), so that a loose shirt is not stretched.
/// Chest and waist are fuller (1.10 and 1.01 m, measured 1.05 and 0.85), because loose cloth would stand off
/// in a ridge without gravity.
std::vector<sim::Body> body_parts(const Stance& stance);

}  // namespace taut::tailor
