#include "sim/solvers/implicit/prediction.hpp"

#include "sim/solvers/implicit/conjugate_gradients.hpp"

namespace taut::sim::implicit {

void predict(const Frame& frame, double time_step_s, double tolerance, const AddConditions& add_conditions,
             BlockMatrix& matrix, State& state) {
  const std::size_t count = state.current.size();
  std::vector<Vec3> velocities(count), forces_n(count), right_side(count), changes(count);
  for (Index v = 0; v < count; ++v) {
    velocities[v] = velocity(state, v);
  }
  matrix.clear();
  const System system = {time_step_s, velocities, matrix, right_side};
  const ExternalForces& external = frame.surroundings.forces;
  add_external_forces(frame.garment, state, external, time_step_s, forces_n);
  add_inertia(frame.garment.masses_kg, forces_n, external.air_drag_per_s, system);
  add_conditions(state, system);

  state.predicted = state.current;
  move_pins(frame.pins, frame.surroundings, time_step_s, state);
  for (const Index pin : frame.pins.vertices) {
    changes[pin] = (state.predicted[pin] - state.current[pin]) / time_step_s - velocities[pin];
  }
  solve(matrix, right_side, frame.pins.inverse_masses_per_kg, tolerance, changes);
  for (std::size_t v = 0; v < count; ++v) {
    if (frame.pins.inverse_masses_per_kg[v] > 0.0) {
      state.predicted[v] += time_step_s * (velocities[v] + changes[v]);
    }
  }
}

}  // namespace taut::sim::implicit
