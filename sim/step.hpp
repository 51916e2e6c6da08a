#pragma once

#include "sim/pins.hpp"
#include "sim/state.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {

/// Eq. (1): p(t + dt) = 2 p(t) - p(t - dt) + a(t) dt^2 with a = f / m (Verlet 1967). Positions are in metres.
/// All spans have one entry per vertex. A pinned vertex (inverse mass 0) is predicted to stay at its current
/// position.
void predict_positions(std::span<const Vec3> previous, std::span<const Vec3> current, std::span<const Vec3> forces_n,
                       std::span<const double> inverse_masses_per_kg, double time_step_s, std::span<Vec3> predicted);

/// Response of one solver's springs: forces before the prediction, corrections after it, or both.
class SpringResponse {
 public:
  virtual ~SpringResponse() = default;

  /// Adds the springs' forces in the current state to `forces_n`, in newtons, one entry per vertex.
  virtual void add_spring_forces(const Garment& garment, const State& state, std::span<Vec3> forces_n) const = 0;

  /// Corrects the predicted positions of free vertices.
  virtual void compensate(const Garment& garment, const Pins& pins, State& state) const = 0;
};

/// Does one time step: Steps 2 and 3 of the paper. Cloth is pushed out of bodies (push_out_of_bodies); its layers pass
/// through each other. `time_step_s` must be above 0. `forces_n` is scratch memory, one entry per vertex, all zero
/// before and after. `wind_fractions`: see find_wind_fractions.
void step(const Garment& garment, const Pins& pins, const Surroundings& surroundings,
          std::span<const float> wind_fractions, const SpringResponse& springs, double time_step_s, State& state,
          std::span<Vec3> forces_n);

/// Part of step(): sets the predicted positions of pins to their prescribed motion.
void move_pins(const Pins& pins, const Surroundings& surroundings, double time_step_s, State& state);
/// Last part of step(): pushes the predicted positions out of bodies and makes them current.
void finish_step(const Garment& garment, const Pins& pins, const Surroundings& surroundings, double time_step_s,
                 State& state);

}  // namespace taut::sim
