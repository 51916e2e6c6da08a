#pragma once

namespace taut::renderer {

/// Returns value truncated and clamped to lowest..highest; NaN gives lowest. Casting a float that no int can
/// hold is undefined, and positions may be anywhere.
inline int whole_within(float value, int lowest, int highest) {
  if (!(value > static_cast<float>(lowest))) return lowest;
  return value < static_cast<float>(highest) ? static_cast<int>(value) : highest;
}

}  // namespace taut::renderer
