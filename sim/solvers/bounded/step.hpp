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

/// The tethers of a cloth: one entry per row, spare rows included. Where pins go ways of their own, tethers
/// are left out of the step.
struct Tethers {
  std::vector<Index> pin;  ///< the row of the pin
  Lanes<Tether> lanes;
};

/// Makes the tethers of a cloth: long-range attachments (Kim, Chentanez and Mueller-Fischer 2012). A vertex
/// cannot be farther from its nearest pin than the way along the cloth, made longer by the part `slack` of
/// it. A sweep hands a correction on by one spring per step; a tether corrects every
/// vertex at once.
Tethers make_tethers(const Garment& garment, const Layout& layout, double slack);

/// Sets the vectors from the pins to the vertices at the start of a frame.
void start_tethers(const StartRows& start, Tethers& tethers);

/// The cloth as time steps change it: its layout, the forces on it and its positions.
struct SteppedCloth {
  /// Makes no tethers and sets no positions.
  SteppedCloth(const Garment& garment, const Pins& pins, const BoundedSettings& settings)
      : layout(make_layout(garment, pins, settings.bound)),
        forces(garment, pins, layout, garment.material.bending_rigidity_n_m),
        contacts(settings.contact, settings.max_stretch),
        elasticity(garment, layout) {}
  SteppedCloth(const SteppedCloth&) = delete;
  SteppedCloth& operator=(const SteppedCloth&) = delete;

  /// The triangles with the rest shapes that time steps hold them to.
  SurfaceLanes& swept_surface() { return elasticity.has_law() ? elasticity.lanes() : layout.surface; }

  Layout layout;
  SlowForces forces;
  Contacts contacts;
  Elasticity elasticity;
  Tethers tethers;  ///< empty where there are none
  Motion motion;
};

/// One of the time steps of a frame. Some stages are not done in every step; this says which are done in this
/// one.
struct TimeStep {
  double frame_began_s = 0.0;
  double frame_ends_s = 0.0;
  double time_s = 0.0;  ///< at the start of this step
  double time_step_s = 0.0;
  bool updates_forces = false;
  /// From one update of the forces to the next.
  double update_interval_s = 0.0;
  bool updates_wind = false;  ///< only where forces are updated
  double wind_interval_s = 0.0;
};

/// Returns how far each pin moves within the time, which begins with the frame, in m, by row.
std::vector<Vec3> pins_moved(const Surroundings& surroundings, const SteppedCloth& cloth, const TimeSpan& time);

/// Does one time step: Steps 2 and 3 of the paper, in the stages of sim/step.cpp. It works on displacements
/// in single precision instead of positions in double precision.
void step(const Frame& frame, const TimeStep& time, ParallelKernels& kernels, SteppedCloth& cloth);

}  // namespace taut::sim::bounded
