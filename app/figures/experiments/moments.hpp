#pragma once

#include <array>

namespace taut::app {

/// Frames of the scene cloth-fall that figure 2 shows: the fall, the swing to the far side and back, and the
/// cloth at rest, which it is some time before the last of them.
inline constexpr std::array fall_frames = {0, 12, 21, 30, 40, 54, 80, 900};

/// For these figures the cloth counts as at rest when for half a second it is no further than this from where
/// it was (root mean square): its swing dies away by a factor of ten every two seconds, and no eye sees it go
/// on.
inline constexpr double fall_rest_m = 1e-4;
inline constexpr double fall_rest_s = 0.5;

/// Frames of the scene tshirt-wind-10 for figure 5. A shirt in this wind flaps and never settles, so that a
/// later moment would cost the most expensive run of all without showing more.
inline constexpr int strong_wind_frames = 100;

}  // namespace taut::app
