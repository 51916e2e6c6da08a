#include "sim/surroundings.hpp"

#include "sim/mesh/elementary.hpp"

namespace taut::sim {

Vec3 pin_offset(const PinMotion& motion, double time_s) {
  return motion.amplitude_m * sine_of_turns(motion.frequency_hz * time_s);
}

bool is_steady(const Surroundings& s) {
  const Wind& wind = s.forces.wind;
  const bool gusts = wind.speed_m_per_s != 0.0 && (wind.gust_amplitude != 0.0 || wind.gust_turn != 0.0);
  return !gusts && s.pin_motion.amplitude_m == Vec3(0.0);
}

}  // namespace taut::sim
