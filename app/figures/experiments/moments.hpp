#pragma once

#include <array>

namespace taut::app {

/// Frames of the scene cloth-fall in figure 2: the fall, the swing to the far side and back, and the cloth at
/// rest. It comes to rest some time before the last of these frames.
inline constexpr std::array fall_frames = {0, 12, 21, 30, 40, 54, 80, 900};

/// In figures 2 and 3 the cloth counts as at rest if it stays within `fall_rest_m` (root mean square over the
/// vertices) for `fall_rest_s`. The swing shrinks to a tenth every two seconds, and such a small one cannot
/// be seen. A larger value ends the run earlier.
inline constexpr double fall_rest_m = 1e-4;
inline constexpr double fall_rest_s = 0.5;

/// Frames of the scene tshirt-wind-10 in figure 5. A shirt in this wind never comes to rest, so a longer run
/// would only cost more.
inline constexpr int strong_wind_frames = 100;

/// The first of its frames that the report's film may dissolve into at its end; it starts some later, when
/// the wind has taken hold of the shirt.
inline constexpr int film_first_frame = 15;

}  // namespace taut::app
