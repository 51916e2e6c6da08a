#pragma once

#include "sim/garment.hpp"
#include "sim/solvers/bounded/contacts.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/motion.hpp"
#include "sim/solvers/bounded/slow_forces.hpp"
#include "sim/solvers/bounded/tethers.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim::bounded {

/// The cloth as time steps work on it: what it is, what acts on it and where it is.
struct SteppedCloth {
  /// Without tethers, and at no place yet.
  SteppedCloth(const Garment& garment, const Pins& pins, double frame_time_s)
      : layout(make_layout(garment, pins)),
        forces(garment, pins, layout, garment.material.bending_rigidity_n_m, frame_time_s) {}
  SteppedCloth(const SteppedCloth&) = delete;
  SteppedCloth& operator=(const SteppedCloth&) = delete;

  Layout layout;
  SlowForces forces;
  Contacts contacts;
  Tethers tethers;  ///< empty where there are none
  Motion motion;
};

/// One of the time steps of a frame, and which of the stages that are not due in every step are due in it.
struct TimeStep {
  double frame_began_s = 0.0;
  double time_s = 0.0;  ///< when this step begins
  double time_step_s = 0.0;
  bool parts_layers = false;
  bool updates_forces = false;
  double update_interval_s = 0.0;  ///< from one update of the forces to the next
};

/// One time step: Steps 2 and 3 of the paper, in the stages of sim/step.cpp, for displacements in single
/// precision instead of positions in double.
void step(const Garment& garment, const Surroundings& surroundings, const TimeStep& time,
          ParallelKernels& kernels, SteppedCloth& cloth);

}  // namespace taut::sim::bounded
