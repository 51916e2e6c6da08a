#pragma once

#include "sim/surroundings.hpp"

namespace taut::sim {

/// Returns surroundings without air, so that nothing but gravity acts.
inline Surroundings vacuum(double gravity_m_per_s2) {
  Surroundings surroundings;
  surroundings.forces.air_drag_per_s = 0.0;
  surroundings.forces.wind.pressure_coefficient = surroundings.forces.wind.friction_coefficient = 0.0;
  surroundings.forces.gravity_m_per_s2 = {0, -gravity_m_per_s2, 0};
  return surroundings;
}

}  // namespace taut::sim
