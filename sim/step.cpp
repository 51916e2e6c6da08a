#include "sim/step.hpp"

#include <algorithm>

#include "sim/verlet.hpp"

namespace taut::sim {
namespace {

void move_pins(const Pins& pins, const PinMotion& motion, double time_step_s, State& state) {
  if (motion.amplitude_m == Vec3(0.0)) {
    return;
  }
  const Vec3 moved = pin_offset(motion, state.time_s + time_step_s) - pin_offset(motion, state.time_s);
  for (const Index pin : pins.vertices) {
    state.predicted[pin] = state.current[pin] + moved;
  }
}

void keep_layers_apart(const Garment& garment, const Pins& pins, double layer_distance_m, State& state,
                       NeighbourList& layers) {
  if (layer_distance_m > 0.0) {
    layers.update(garment.mesh.positions, state.predicted, layer_distance_m);
    push_layers_apart(layers.pairs(), layer_distance_m, pins.inverse_masses_per_kg, state.predicted);
  }
}

}  // namespace

void step(const Garment& garment, const Pins& pins, const Surroundings& surroundings,
          const SpringResponse& springs, double time_step_s, State& state, StepBuffers& buffers) {
  std::vector<Vec3>& forces_n = buffers.forces_n;
  set_time_step(state, time_step_s);

  // Step 2: impose the forces on the mass points and predict where they go, eq. (1).
  add_external_forces(garment, state, surroundings.forces, time_step_s, forces_n);
  springs.add_spring_forces(garment, state, forces_n);
  predict_positions(state.previous, state.current, forces_n, pins.inverse_masses_per_kg, time_step_s,
                    state.predicted);
  move_pins(pins, surroundings.pin_motion, time_step_s, state);

  keep_layers_apart(garment, pins, surroundings.layer_distance_m, state, buffers.layers);

  // Step 3: compensate the predicted positions, eqs. (2)-(3), and eliminate the forces.
  springs.compensate(garment, pins, state);
  push_out_of_colliders(surroundings.colliders, garment.material, pins.inverse_masses_per_kg, state.current,
                        state.predicted);
  std::fill(forces_n.begin(), forces_n.end(), Vec3(0.0));

  rotate_positions(state);
  state.time_s += time_step_s;
  ++state.step_count;
}

}  // namespace taut::sim
