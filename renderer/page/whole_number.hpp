#pragma once

namespace taut::renderer {

/// A number's whole part, kept within two bounds; the lower one for what is not a number. A plain cast of a
/// float that no int can hold is undefined, and positions may be anywhere.
inline int whole_within(float value, int lowest, int highest) {
  if (!(value > static_cast<float>(lowest))) return lowest;
  return value < static_cast<float>(highest) ? static_cast<int>(value) : highest;
}

}  // namespace taut::renderer
