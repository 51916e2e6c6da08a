#pragma once

#include "sim/solvers/implicit/system.hpp"

namespace taut::sim {

/// Settings of `implicit`. Bending uses the rigidity of the cloth's material.
struct ImplicitSettings {
  double stretch_n_per_m = 1000.0;  ///< along warp and weft; higher values stretch less and take more iterations
  /// Stiffness against shear, a change of the angle between warp and weft. At half of the above the cloth is isotropic;
  /// lower values drape more easily.
  double shear_n_per_m = 500.0;
  /// Damping of each stiffness, as a fraction of it per unit of time. Higher values come to rest sooner.
  double damping_s = 0.005;
  /// Residual at which the conjugate gradients stop, as a fraction of the first one. Lower values are more exact and
  /// take more iterations.
  double tolerance = 1e-4;
  /// Largest change of a triangle's stretch along warp or weft in one time step; steps that exceed it are halved. Lower
  /// values take shorter steps where much happens.
  double max_stretch_change = 0.1;

  bool operator==(const ImplicitSettings&) const = default;
};

/// Large steps by backward Euler (Baraff and Witkin 1998). Triangles resist stretch and shear, and edges resist
/// bending; a model without triangles falls apart. Each time step solves one linear system for the change of velocities
/// (system.hpp). Pins are constraints of that system. Cloth is pushed out of bodies as by the explicit solvers; its
/// layers pass through each other. Wind and hands act as forces at the start of the step.
///
/// The time step adapts (section 6). It begins as a whole frame, is halved if a triangle's stretch changes too much in
/// it, and doubled after two successful steps. Longer steps damp more.
class ImplicitSolver : public Solver {
 public:
  /// `substeps` is the number of equal steps per frame. If not set, the step adapts, down to a frame divided by the
  /// largest power of 2 up to `max_substeps`, which must be at least 1.
  ImplicitSolver(const ImplicitSettings& settings, std::optional<int> substeps, int max_substeps);

  FrameReport advance_frame(const Frame& frame, State& state) override;
  void keep_frame() override { halvings_ = next_halvings_; }
  void save(const Garment& garment, const Pins& pins, ByteWriter& memory) const override;
  void restore(const Frame& frame, ByteReader& memory) override;

 private:
  void prepare(const Garment& garment);
  void predict(const Frame& frame, double time_step_s, State& state);
  bool stretch_changes_too_much(const State& state) const;
  int adapt(const Frame& frame, State& state);

  ImplicitSettings settings_;
  std::optional<int> substeps_;
  int max_halvings_ = 0;

  int halvings_ = 0;       ///< the time step is a frame divided by 2 to this power
  int next_halvings_ = 0;  ///< value after the frame that is not kept yet

  std::vector<implicit::WovenTriangle> triangles_;
  std::vector<implicit::Hinge> hinges_;
  implicit::BlockMatrix matrix_;
};

}  // namespace taut::sim
