#pragma once

#include "sim/garment.hpp"
#include "sim/solvers/bounded/contacts.hpp"
#include "sim/solvers/bounded/elasticity.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/motion.hpp"
#include "sim/solvers/bounded/slow_forces.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim::bounded {

/// Tethers of a cloth, one entry per solver index including padding. Steps ignore them if pins have motions of their
/// own.
struct Tethers {
  std::vector<Index> pin;  ///< solver index of the pin
  Lanes<Tether> lanes;
};

/// Makes the tethers of a cloth: long-range attachments (Kim, Chentanez and Mueller-Fischer 2012). The distance of a
/// vertex from its nearest pin cannot exceed the length of the path along the cloth times 1 + `slack`. A sweep passes a
/// correction on by one spring; a tether corrects every vertex at once.
Tethers make_tethers(const Garment& garment, const Layout& layout, double slack);

/// Sets the vectors from the pins to the vertices at the start of a frame.
void start_tethers(const StartRows& start, Tethers& tethers);

/// State of the cloth within a frame: its layout, forces and positions.
struct SteppedCloth {
  /// Leaves tethers and positions empty.
  SteppedCloth(const Garment& garment, const Pins& pins, const BoundedSettings& settings)
      : layout(make_layout(garment, pins, settings.bound)),
        forces(garment, pins, layout, garment.material.bending_rigidity_n_m),
        contacts(settings.contact, settings.max_stretch),
        elasticity(garment, layout) {}
  SteppedCloth(const SteppedCloth&) = delete;
  SteppedCloth& operator=(const SteppedCloth&) = delete;

  /// Returns the triangles with the rest shapes that time steps use.
  SurfaceLanes& swept_surface() { return elasticity.has_law() ? elasticity.lanes() : layout.surface; }

  Layout layout;
  SlowForces forces;
  Contacts contacts;
  Elasticity elasticity;
  Tethers tethers;  ///< empty without tethers
  Motion motion;
};

/// One time step of a frame, with the stages that it includes.
struct TimeStep {
  double frame_began_s = 0.0;
  double frame_ends_s = 0.0;
  double time_s = 0.0;  ///< time at the start of this step
  double time_step_s = 0.0;
  bool updates_forces = false;
  /// Time between two force updates.
  double update_interval_s = 0.0;
  bool updates_wind = false;  ///< only where forces are updated
  double wind_interval_s = 0.0;
};

/// Returns the displacement of each pin within the time, which begins with the frame, in m, by solver index.
std::vector<Vec3> pins_moved(const Surroundings& surroundings, const SteppedCloth& cloth, const TimeSpan& time);

/// Does one time step: Steps 2 and 3 of the paper, in the stages of sim/step.cpp. It works on displacements in single
/// precision instead of positions in double precision.
void step(const Frame& frame, const TimeStep& time, ParallelKernels& kernels, SteppedCloth& cloth);

}  // namespace taut::sim::bounded
