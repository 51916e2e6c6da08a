#include "sim/step.hpp"

namespace taut::sim {

void predict_positions(std::span<const Vec3> previous, std::span<const Vec3> current, std::span<const Vec3> forces_n,
                       std::span<const double> inverse_masses_per_kg, double time_step_s, std::span<Vec3> predicted) {
  assert(time_step_s > 0.0);
  const std::size_t n = current.size();
  assert(previous.size() == n && forces_n.size() == n && inverse_masses_per_kg.size() == n);
  assert(predicted.size() == n);
  const double dt_squared = time_step_s * time_step_s;
  for (std::size_t v = 0; v < n; ++v) {
    if (inverse_masses_per_kg[v] == 0.0) {
      predicted[v] = current[v];
      continue;
    }
    const Vec3 acceleration = forces_n[v] * inverse_masses_per_kg[v];
    // Adding the small difference loses fewer digits than 2 p(t) - p(t - dt).
    predicted[v] = current[v] + ((current[v] - previous[v]) + acceleration * dt_squared);
  }
}

namespace {

void impose_forces(const Garment& garment, const ExternalForces& external, std::span<const float> wind_fractions,
                   const SpringResponse& springs, double time_step_s, const State& state, std::span<Vec3> forces_n) {
  add_external_forces(garment, state, external, wind_fractions, time_step_s, forces_n);
  springs.add_spring_forces(garment, state, forces_n);
}

void predict(const Pins& pins, std::span<const Vec3> forces_n, double time_step_s, State& state) {
  predict_positions(state.previous, state.current, forces_n, pins.inverse_masses_per_kg, time_step_s, state.predicted);
}

void constrain(const Garment& garment, const Pins& pins, const SpringResponse& springs, State& state) {
  springs.compensate(garment, pins, state);
}

}  // namespace

void move_pins(const Pins& pins, const Surroundings& surroundings, double time_step_s, State& state) {
  assert(time_step_s > 0.0);
  assert(state.current.size() == pins.inverse_masses_per_kg.size());
  if (surroundings.pin_motion.amplitude_m == Vec3(0.0) && !has_pins_of_their_own(surroundings)) return;
  std::vector<Vec3> from_m;
  for (const Index pin : pins.vertices) from_m.push_back(state.current[pin]);
  const std::vector<Vec3> moved_m =
      pin_displacements(surroundings, pins.vertices, from_m, {state.time_s, state.time_s + time_step_s});
  for (std::size_t k = 0; k < moved_m.size(); ++k) state.predicted[pins.vertices[k]] = from_m[k] + moved_m[k];
}

void finish_step(const Garment& garment, const Pins& pins, const Surroundings& surroundings, double time_step_s,
                 State& state) {
  assert(time_step_s > 0.0);
  const Material& cloth = garment.material;
  push_out_of_bodies(surroundings.bodies, {cloth.thickness_m, cloth.friction},
                     {state.time_s, state.time_s + time_step_s}, pins.inverse_masses_per_kg, state.current,
                     state.predicted);
  rotate_positions(state);
  state.time_step_s = time_step_s;
  state.time_s += time_step_s;
  ++state.step_count;
}

void step(const Garment& garment, const Pins& pins, const Surroundings& surroundings,
          std::span<const float> wind_fractions, const SpringResponse& springs, double time_step_s, State& state,
          std::span<Vec3> forces_n) {
  assert(time_step_s > 0.0);
  assert(forces_n.size() == state.current.size());
  set_time_step(state, time_step_s);

  // Step 2: impose the forces on the mass points ...
  impose_forces(garment, surroundings.forces, wind_fractions, springs, time_step_s, state, forces_n);
  // ... and predict where they go, eq. (1): p(t+dt) = 2 p(t) - p(t-dt) + a dt^2.
  predict(pins, forces_n, time_step_s, state);
  move_pins(pins, surroundings, time_step_s, state);

  // Step 3: compensate the predicted positions, eqs. (2)-(3), and eliminate the forces.
  constrain(garment, pins, springs, state);
  std::fill(forces_n.begin(), forces_n.end(), Vec3(0.0));

  finish_step(garment, pins, surroundings, time_step_s, state);
}

}  // namespace taut::sim
