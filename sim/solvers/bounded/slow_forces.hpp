#pragma once

#include "sim/forces.hpp"
#include "sim/solvers/bounded/bending.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/motion.hpp"

namespace taut::sim::bounded {

/// Forces that change little in one time step: gravity, wind, bending, artificial forces and hands. They are evaluated
/// a few times per frame and constant in between (multiple time steps, like the slow forces of Tuckerman, Berne and
/// Martyna 1992).
class SlowForces {
 public:
  /// `layout` must outlive this object.
  SlowForces(const Garment& garment, const Pins& pins, const Layout& layout, double bending_rigidity_n_m);

  /// Returns the evaluations per frame that keep the cloth stable although forces are constant in between.
  int updates_per_frame(double frame_time_s) const;
  /// Returns the evaluations per frame of the wind alone, which turns with the cloth and need not follow bending waves.
  static int wind_updates_per_frame(double frame_time_s);

  /// Begins an attempt at a frame from the state of the last wind update: the velocities in m/s that the wind alone
  /// would have caused until now, by solver index. Empty if unknown.
  void begin_attempt(const Float4Array& wind_velocity_m_per_s, std::span<const float> wind_fractions);
  const Float4Array& wind_velocity_m_per_s() const { return wind_velocity_m_per_s_; }

  /// Evaluates the wind at the current motion, for the updates of the next `interval_s`. `time_step_s` is the time
  /// between the two displacements of `motion`. Drag uses the air velocity relative to the cloth at the end of the
  /// interval. It assumes that other forces, including pins, change velocities by the same amount as since the last
  /// update. So pinned cloth takes the whole pressure, and falling cloth has its terminal speed.
  void update_wind(const Garment& garment, const Wind& wind, const Motion& motion, double time_s, double time_step_s,
                   double interval_s, ParallelKernels& kernels);

  /// Evaluates all other forces at the current motion and adds the wind. The result, accelerations(), applies for the
  /// next `interval_s`. Requires that the vertices of artificial forces and hands exist.
  void update(const Garment& garment, const ExternalForces& external, const Motion& motion, double time_s,
              double time_step_s, double interval_s, ParallelKernels& kernels);

  /// Accelerations by solver index, in m/s^2; 0 in padding.
  const Float4* accelerations() const { return accelerations_.data(); }

 private:
  void add_gravity_and_artificial(const ExternalForces& external, double time_s);
  void add_hand(const Garment& garment, const ExternalForces& external, const Motion& motion, double time_step_s,
                double interval_s);
  void find_constraint_velocity(const Motion& motion, double time_step_s);
  void add_wind(ParallelKernels& kernels);
  void add_bending(const Motion& motion, double ahead, ParallelKernels& kernels);

  const Layout& layout_;
  Bending bending_;
  Float4Array accelerations_;
  Float4Array corner_forces_n_;
  Float4Array wind_accelerations_;  ///< accelerations of the last wind update by solver index, in m/s^2
  Float4Array wind_velocity_m_per_s_;
  Lanes<float> wind_fractions_;              ///< see Frame; one per lane, 1 without wind and in padding
  Float4Array constraint_velocity_m_per_s_;  ///< velocity changes by solver index, see Kernels::wind
  Float4Array positions_;
};

}  // namespace taut::sim::bounded
