#include "sim/solvers/bounded/step.hpp"

#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
namespace {

void impose_forces(const Garment& garment, const ExternalForces& external, const TimeStep& time,
                   ParallelKernels& kernels, SteppedCloth& cloth) {
  if (time.updates_wind) {
    cloth.forces.update_wind(garment, external.wind, cloth.motion, time.time_s, time.time_step_s, time.wind_interval_s,
                             kernels);
  }
  cloth.forces.update(garment, external, cloth.motion, time.time_s, time.time_step_s, time.update_interval_s, kernels);
}

/// Returns the time from the start of the frame to the end of the step.
TimeSpan since_frame_began(const TimeStep& time) { return {time.frame_began_s, time.time_s + time.time_step_s}; }

void predict(const Surroundings& surroundings, const TimeStep& time, ParallelKernels& kernels, SteppedCloth& cloth) {
  Prediction prediction;
  prediction.decay = static_cast<float>(1.0 / (1.0 + surroundings.forces.air_drag_per_s * time.time_step_s));
  prediction.dt_squared = static_cast<float>(time.time_step_s * time.time_step_s);
  prediction.pins_moved = to_float4(pin_displacement(surroundings.pin_motion, since_frame_began(time)));
  // The kernel supports only a common motion of all pins.
  const bool is_tethered = !cloth.tethers.lanes.empty() && !has_pins_of_their_own(surroundings);
  const Tether* tethers = is_tethered ? cloth.tethers.lanes.data() : nullptr;
  kernels.predict(prediction, tethers, cloth.forces.accelerations(), cloth.motion.current, cloth.motion.previous);
  cloth.motion.previous.swap(cloth.motion.current);
}

void move_pins(const Surroundings& surroundings, const TimeStep& time, SteppedCloth& cloth) {
  const std::vector<Vec3> moved_m = pins_moved(surroundings, cloth, since_frame_began(time));
  std::transform(moved_m.begin(), moved_m.end(), cloth.motion.current.begin(), to_float4);
}

void constrain(ParallelKernels& kernels, SteppedCloth& cloth) {
  Float4* rows = cloth.motion.current.data();
  for (const BlockRange& range : cloth.layout.springs.sweep) kernels.sweep(cloth.layout.springs, range, rows);
  const SurfaceLanes& surface = cloth.swept_surface();
  for (const BlockRange& range : surface.sweep) kernels.sweep(surface, range, cloth.elasticity.sums(), rows);
}

/// Time span of regions, with a bound in m on the distance of pins and bodies from their chords.
struct StraightSpan {
  TimeSpan time;
  double off_chord_m;
};

/// Shortens the span until these distances fit between the planes, down to one time step: at both ends of a chord the
/// distance is 0.
StraightSpan straight_span(const Garment& garment, const Surroundings& surroundings, const SteppedCloth& cloth,
                           const TimeStep& time, double end_s) {
  const std::size_t count = cloth.layout.pin_count;
  const auto pins = std::span(cloth.layout.vertex_indices).first(count);
  const auto pins_m = std::span(cloth.motion.start_m).first(count);
  double steps = std::round((end_s - time.time_s) / time.time_step_s);
  while (true) {
    const TimeSpan span = {time.time_s, end_s};
    const double off_chord_m = std::max(pins_off_chord_m(surroundings, pins, pins_m, time.frame_began_s, span),
                                        cloth.contacts.bodies_off_chord_m(span));
    if (steps <= 1.0 || off_chord_m <= max_off_chord_fraction * garment.material.thickness_m) {
      return {span, off_chord_m};
    }
    steps = std::ceil(0.5 * steps);
    end_s = time.time_s + steps * time.time_step_s;
  }
}

// The duration of regions depends on the observed speed. If they do not fit, half the time halves the motion into
// obstacles.
void renew_regions(const Frame& frame, const TimeStep& time, ParallelKernels& kernels, SteppedCloth& cloth) {
  const Surroundings& surroundings = frame.surroundings;
  Contacts& contacts = cloth.contacts;
  contacts.observe(cloth.layout, cloth.motion, time.time_s);
  double end_s = contacts.suitable_end_s(time.time_s, time.time_step_s, time.frame_ends_s);
  bool fits = false;
  while (!fits) {
    const auto [span, off_chord_m] = straight_span(frame.garment, surroundings, cloth, time, end_s);
    const double steps = std::round((span.to_s - time.time_s) / time.time_step_s);
    fits = contacts.make_regions(frame, cloth.layout, cloth.motion, cloth.forces.accelerations(),
                                 pins_moved(surroundings, cloth, {time.frame_began_s, span.to_s}), off_chord_m, span,
                                 steps > 1.0, kernels);
    end_s = time.time_s + std::ceil(0.5 * steps) * time.time_step_s;
  }
}

}  // namespace

Tethers make_tethers(const Garment& garment, const Layout& layout, double slack) {
  assert(slack >= 0.0);
  Tethers tethers;
  tethers.pin.resize(layout.row_count(), 0);
  tethers.lanes.resize(layout.row_count());
  const double stretched = 1.0 + slack;
  const std::vector<Vec3>& rest_positions_m = garment.mesh.positions;
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    const double along_m = layout.distance_from_pins_m[row];
    if (!std::isfinite(along_m)) continue;
    const Index pin = layout.nearest_pin_row[row];
    // The distance along the cloth can be slightly too short, but the cloth must fit at rest.
    const double straight_m =
        glm::length(rest_positions_m[layout.vertex_indices[row]] - rest_positions_m[layout.vertex_indices[pin]]);
    const double length_m = stretched * std::max(along_m, straight_m);
    tethers.pin[row] = pin;
    tethers.lanes[row].squared_length = static_cast<float>(length_m * length_m);
  }
  return tethers;
}

void start_tethers(const StartRows& start, Tethers& tethers) {
  const auto& [high, low] = start;
  for (std::size_t row = 0; row < tethers.lanes.size(); ++row) {
    const Index pin = tethers.pin[row];
    Tether& tether = tethers.lanes[row];
    tether.start_x = (high[row].x - high[pin].x) + (low[row].x - low[pin].x);
    tether.start_y = (high[row].y - high[pin].y) + (low[row].y - low[pin].y);
    tether.start_z = (high[row].z - high[pin].z) + (low[row].z - low[pin].z);
  }
}

std::vector<Vec3> pins_moved(const Surroundings& surroundings, const SteppedCloth& cloth, const TimeSpan& time) {
  const std::size_t count = cloth.layout.pin_count;
  return pin_displacements(surroundings, std::span(cloth.layout.vertex_indices).first(count),
                           std::span(cloth.motion.start_m).first(count), time);
}

void step(const Frame& frame, const TimeStep& time, ParallelKernels& kernels, SteppedCloth& cloth) {
  const Surroundings& surroundings = frame.surroundings;
  frame.ask();
  // Step 2: impose the forces on the mass points, a few times in a frame ...
  if (time.updates_forces) impose_forces(frame.garment, surroundings.forces, time, kernels, cloth);
  // ... find near pairs, as often as the cloth's motion requires ...
  if (cloth.contacts.are_due(time.time_s, time.time_step_s)) renew_regions(frame, time, kernels, cloth);
  // ... and predict where they go, eq. (1): d(t+dt) = d(t) + (d(t) - d(t-dt)) / (1 + c dt) + a dt^2.
  predict(surroundings, time, kernels, cloth);
  move_pins(surroundings, time, cloth);

  // Step 3: compensate the predicted displacements, eqs. (2)-(3).
  constrain(kernels, cloth);
  cloth.elasticity.count_step();
  if (cloth.contacts.is_on()) {
    cloth.contacts.keep_apart(cloth.layout, time.time_s + time.time_step_s, time.time_step_s, kernels, cloth.motion);
  }
}

}  // namespace taut::sim::bounded
