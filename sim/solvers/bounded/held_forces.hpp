#pragma once

#include "sim/forces.hpp"
#include "sim/solvers/bounded/bending.hpp"
#include "sim/solvers/bounded/kernels/loops.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim::bounded {

/// Where the cloth is within a frame: displacements since the frame's start in single precision. Absolute
/// positions would round away the motion of cloth that is nearly at rest, and never let it come to rest.
struct Motion {
  std::vector<Vec3> start_m;  ///< positions when the frame began, by row
  StartRows start;            ///< the same, for kernels
  Rows current;               ///< displacements now
  Rows previous;              ///< and one time step ago
};

/// Forces that change slowly against a time step are evaluated at a few times in a frame and held in between:
/// gravity, wind, bending and artificial forces.
class HeldForces {
 public:
  /// `layout` has to outlive this.
  HeldForces(const Garment& garment, const Pins& pins, const Layout& layout, double bending_rigidity_n_m,
             double frame_time_s);

  /// How often a frame the forces have to be evaluated so that holding them is stable.
  int updates_per_frame(const ExternalForces& external, double frame_time_s) const;

  /// Evaluates all forces as accelerations by row, in m/s^2, for the next `held_s`.
  void update(const Garment& garment, const ExternalForces& external, const Motion& motion, double time_s,
              double time_step_s, double held_s, Loops& loops);

  const Row* accelerations() const { return accelerations_.data(); }

 private:
  void add_gravity_and_artificial(const ExternalForces& external);
  void add_hand(const Garment& garment, const ExternalForces& external, const Motion& motion,
                double time_step_s, double held_s);
  void add_wind(const Garment& garment, const Wind& wind, const Motion& motion, double time_s,
                double time_step_s, double held_s, Loops& loops);
  void add_bending(const Motion& motion, double ahead, Loops& loops);

  const Layout& layout_;
  Bending bending_;
  Rows accelerations_;
  Rows corner_forces_n_;
  Rows positions_;
};

}  // namespace taut::sim::bounded
