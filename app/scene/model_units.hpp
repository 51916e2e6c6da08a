#pragma once

#include <array>

namespace taut::app {

/// A unit of length.
struct Unit {
  const char* symbol;  ///< as the option --units takes it
  const char* name;
  double metres;  ///< length of the unit
};

/// Units a model may be in.
inline constexpr std::array units = {Unit{"m", "metre", 1.0},         Unit{"cm", "centimetre", 0.01},
                                     Unit{"mm", "millimetre", 0.001}, Unit{"dm", "decimetre", 0.1},
                                     Unit{"in", "inch", 0.0254},      Unit{"ft", "foot", 0.3048}};

/// A direction in a model's own coordinates.
enum class ModelAxis { x, minus_x, y, minus_y, z, minus_z };

/// Names of the directions, indexed by ModelAxis.
inline constexpr std::array axis_names = {"x", "-x", "y", "-y", "z", "-z"};

}  // namespace taut::app
