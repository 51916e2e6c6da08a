#pragma once

#include "sim/forces.hpp"
#include "sim/solvers/bounded/bending.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/motion.hpp"

namespace taut::sim::bounded {

/// Forces that change little in one time step: gravity, wind, bending, artificial forces and those of hands.
/// They are evaluated a few times per frame and stay constant in between (multiple time steps, like the slow
/// forces of Tuckerman, Berne and Martyna 1992).
class SlowForces {
 public:
  /// `layout` must outlive this object.
  SlowForces(const Garment& garment, const Pins& pins, const Layout& layout, double bending_rigidity_n_m);

  /// Returns how many evaluations per frame keep the cloth stable although the forces stay constant in
  /// between.
  int updates_per_frame(double frame_time_s) const;
  /// The same for the wind alone, which turns with the cloth and need not follow waves of bending.
  static int wind_updates_per_frame(double frame_time_s);

  /// Begins where the wind was last updated: by row, the velocities in m/s that the wind alone would have brought
  /// about until now. Empty where that is not known.
  void begin_attempt(const Float4Array& blown_m_per_s) { blown_m_per_s_ = blown_m_per_s; }
  const Float4Array& blown_m_per_s() const { return blown_m_per_s_; }

  /// Evaluates the wind at the current motion, for the updates of the next `interval_s`. `time_step_s` is the
  /// time between the two displacements of `motion`. Drag goes by the air's velocity relative to the cloth at the
  /// end of that time. It counts on other forces, pins among them, to change velocities by as much as they did since
  /// the last update: cloth that is held takes the whole pressure, and cloth that falls has its terminal speed.
  void update_wind(const Garment& garment, const Wind& wind, const Motion& motion, double time_s, double time_step_s,
                   double interval_s, ParallelKernels& kernels);

  /// Evaluates all other forces at the current motion and adds the wind. The result, accelerations(), is used
  /// for the next `interval_s`. Requires that the vertices of artificial forces and hands exist.
  void update(const Garment& garment, const ExternalForces& external, const Motion& motion, double time_s,
              double time_step_s, double interval_s, ParallelKernels& kernels);

  /// By row, in m/s^2; 0 in spare rows.
  const Float4* accelerations() const { return accelerations_.data(); }

 private:
  void add_gravity_and_artificial(const ExternalForces& external, double time_s);
  void add_hand(const Garment& garment, const ExternalForces& external, const Motion& motion, double time_step_s,
                double interval_s);
  void find_opposed(const Motion& motion, double time_step_s);
  void add_wind(ParallelKernels& kernels);
  void add_bending(const Motion& motion, double ahead, ParallelKernels& kernels);

  const Layout& layout_;
  Bending bending_;
  Float4Array accelerations_;
  Float4Array corner_forces_n_;
  Float4Array wind_accelerations_;  ///< by row, in m/s^2, of the last update of the wind
  Float4Array blown_m_per_s_;
  Float4Array opposed_;  ///< by row, as the kernel of the wind takes it
  Float4Array positions_;
};

}  // namespace taut::sim::bounded
