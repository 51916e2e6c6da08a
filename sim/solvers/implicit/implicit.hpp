#pragma once

#include "sim/solvers/implicit/system.hpp"

namespace taut::sim {

/// The settings of `implicit`. Bending takes the rigidity of the cloth's material.
struct ImplicitSettings {
  double stretch_n_per_m = 1000.0;  ///< along warp and weft; more stretches less and takes more iterations
  /// Against a change of the angle between warp and weft. At half of the above the cloth answers alike in all
  /// directions; less drapes more easily.
  double shear_n_per_m = 500.0;
  /// The damping of each stiffness, as a fraction of it per unit of time. More comes to rest sooner.
  double damping_s = 0.005;
  /// The residual at which the conjugate gradients stop, as a fraction of the first one. Less is more exact
  /// and takes more iterations.
  double tolerance = 1e-4;
  /// A time step in which a triangle's stretch along warp or weft changes by more is done again in two. Less
  /// takes shorter steps where much happens.
  double largest_stretch_change = 0.1;

  bool operator==(const ImplicitSettings&) const = default;
};

/// Large steps by backward Euler (Baraff and Witkin 1998). Triangles oppose stretch and shear, edges bending
/// (system.hpp); a model without triangles falls apart. Each time step solves one linear system for the
/// change of velocities (system.hpp). Pins are constraints of that system. Cloth is pushed out of bodies as
/// by the explicit solvers; its layers pass through each other. Wind and hands are forces of the step's
/// beginning.
///
/// The time step adapts (section 6): it begins as a whole frame, is halved where a triangle's stretch changes
/// too much in it, and doubled after two steps that went well. The numerical damping grows with it.
class ImplicitSolver : public Solver {
 public:
  /// `substeps` divides every frame into so many equal steps; none lets the step adapt, down to
  /// a frame divided by the largest power of 2 that is at most `max_substeps`, which must be at least 1.
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
  int most_halvings_ = 0;

  int halvings_ = 0;       ///< the time step is a frame divided by 2 to this power
  int next_halvings_ = 0;  ///< after the frame that is not kept yet

  std::vector<implicit::WovenTriangle> triangles_;
  std::vector<implicit::Hinge> hinges_;
  implicit::BlockMatrix matrix_;
};

}  // namespace taut::sim
