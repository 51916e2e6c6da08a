#include "sim/solvers/bounded/step.hpp"

#include <algorithm>

namespace taut::sim::bounded {
namespace {

void part_layers(const Garment& garment, double layer_distance_m, SteppedCloth& cloth) {
  if (layer_distance_m > 0.0) {
    cloth.contacts.part_layers(garment, cloth.layout, layer_distance_m, cloth.motion);
  }
}

void impose_forces(const Garment& garment, const ExternalForces& external, const TimeStep& time,
                   ParallelKernels& kernels, SteppedCloth& cloth) {
  cloth.forces.update(garment, external, cloth.motion, time.time_s, time.time_step_s, time.update_interval_s,
                      kernels);
}

/// Returns how far pins have moved from the start of the frame to the end of the step, in m.
Float4 pins_moved(const PinMotion& motion, const TimeStep& time) {
  return float4_of(pin_displacement(motion, time.frame_began_s, time.time_s + time.time_step_s));
}

void predict(const Surroundings& surroundings, const TimeStep& time, ParallelKernels& kernels,
             SteppedCloth& cloth) {
  Prediction prediction;
  prediction.decay = static_cast<float>(1.0 / (1.0 + surroundings.forces.air_drag_per_s * time.time_step_s));
  prediction.dt_squared = static_cast<float>(time.time_step_s * time.time_step_s);
  prediction.pins_moved = pins_moved(surroundings.pin_motion, time);
  const Tether* tethers = cloth.tethers.lanes.empty() ? nullptr : cloth.tethers.lanes.data();
  kernels.predict(prediction, tethers, cloth.forces.accelerations(), cloth.motion.current,
                  cloth.motion.previous);
  cloth.motion.previous.swap(cloth.motion.current);
}

void move_pins(const PinMotion& motion, const TimeStep& time, SteppedCloth& cloth) {
  std::fill_n(cloth.motion.current.begin(), cloth.layout.pin_count, pins_moved(motion, time));
}

template <typename AnyLanes>
void sweep(const AnyLanes& lanes, ParallelKernels& kernels, SteppedCloth& cloth) {
  for (const BlockRange& range : lanes.sweep) {
    kernels.sweep(lanes, range, cloth.motion.current.data());
  }
}

void constrain(ParallelKernels& kernels, SteppedCloth& cloth) {
  sweep(cloth.layout.springs, kernels, cloth);
  sweep(cloth.layout.surface, kernels, cloth);
}

void push_out(const Material& material, const Surroundings& surroundings, const TimeStep& time,
              SteppedCloth& cloth) {
  cloth.contacts.push_out(material, surroundings, {time.time_s, time.time_s + time.time_step_s},
                          cloth.motion);
}

}  // namespace

void step(const Garment& garment, const Surroundings& surroundings, const TimeStep& time,
          ParallelKernels& kernels, SteppedCloth& cloth) {
  // Layers come first, so that the prediction no longer has the speed that this removes.
  if (time.parts_layers) {
    part_layers(garment, surroundings.layer_distance_m, cloth);
  }

  // Step 2: impose the forces on the mass points, a few times in a frame ...
  if (time.updates_forces) {
    impose_forces(garment, surroundings.forces, time, kernels, cloth);
  }
  // ... and predict where they go, eq. (1): d(t+dt) = d(t) + (d(t) - d(t-dt)) / (1 + c dt) + a dt^2.
  predict(surroundings, time, kernels, cloth);
  move_pins(surroundings.pin_motion, time, cloth);

  // Step 3: compensate the predicted displacements, eqs. (2)-(3).
  constrain(kernels, cloth);
  push_out(garment.material, surroundings, time, cloth);
}

}  // namespace taut::sim::bounded
