#pragma once

#include <array>

namespace taut::app {

/// From where a scene is seen. Angles as those of camera.azimuth and camera.elevation, in degrees.
struct Side {
  const char* name;
  double azimuth_deg;
  double elevation_deg;
};

/// The sides that have a name. The window has keys for the first four.
inline constexpr std::array<Side, 6> sides = {{{"front", 0.0, 5.0},
                                               {"side", 90.0, 5.0},
                                               {"back", 180.0, 5.0},
                                               {"three-quarter", 38.0, 15.0},
                                               {"left", -90.0, 5.0},
                                               {"top", 0.0, 85.0}}};

}  // namespace taut::app
