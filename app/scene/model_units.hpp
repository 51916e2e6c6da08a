#pragma once

#include <array>

namespace taut::app {

struct Unit {
  const char* symbol;  ///< as `--units` takes it
  const char* name;
  double metres;
};

inline constexpr std::array units = {Unit{"m", "metre", 1.0},         Unit{"cm", "centimetre", 0.01},
                                     Unit{"mm", "millimetre", 0.001}, Unit{"dm", "decimetre", 0.1},
                                     Unit{"in", "inch", 0.0254},      Unit{"ft", "foot", 0.3048}};

/// A direction of a model's own coordinates.
enum class ModelAxis { x, minus_x, y, minus_y, z, minus_z };

/// "x", "-x", ... by ModelAxis.
inline constexpr std::array axis_names = {"x", "-x", "y", "-y", "z", "-z"};

}  // namespace taut::app
