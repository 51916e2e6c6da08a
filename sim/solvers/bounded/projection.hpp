#pragma once

#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {

/// Work of one round, in sweeps: the over-relaxed sweeps, an exact one, and a check of all lengths.
inline const double round_sweeps = tuning::relaxed_sweeps + 2.0;

/// Result of a projection onto the bound.
struct ProjectionResult {
  double raw_max_stretch = 0.0;  ///< largest stretch of springs or triangles before the projection
  double cost = 0.0;             ///< work, in sweeps over all springs and triangles
  double max_shift_m = 0.0;      ///< largest motion of a vertex
  bool is_kept = false;          ///< the bound is kept
};

/// Convex region of each vertex that a correction has to stay in, besides the bound.
class Confinement {
 public:
  virtual ~Confinement() = default;
  /// Begins a correction of the displacements `raw`; `expected` is the predicted correction.
  virtual void begin(const Float4Array& raw, const Float4Array& expected) = 0;
  /// Projects displacements into the regions. If the correction is stuck, obstacles in its way are predicted to give
  /// way.
  virtual void project_into_region(Float4Array& displacements, bool is_stuck) = 0;
  /// Returns whether the work exceeds the budget, after this number of sweeps.
  virtual bool is_spent(double /*sweeps*/) const { return false; }
};

/// Moves `rows` towards the bound by a few sweeps over long springs and triangles. `rows` are displacements since the
/// start of the frame, in m.
void shorten_roughly(const Layout& layout, double max_stretch, ParallelKernels& kernels, Float4Array& rows);

/// Returns the factor of over-relaxed sweeps. Below 2 no sweep increases the distance to any shape within the bound,
/// whatever the weights (Agmon 1954). The best factor for a chain of n springs is 2 / (1 + sin(pi / n)) (Young 1954);
/// the weights make chains shorter.
float relaxation_factor(const Layout& layout);
/// Returns the stretch that the last correction of a frame aims at, slightly below the bound.
double aimed_stretch(double max_stretch);

/// Last correction of a frame: moves the cloth to a shape in which no spring, or no triangle in any direction, is
/// longer than the bound.
///
/// The shapes with all springs within a bound are a convex set. The same holds for triangles: a singular value is a
/// norm of a linear function of positions. So repeated correction of the longer ones converges to such a shape if the
/// pins allow one (cyclic projection; Bregman 1965). That holds for any vertex weights, so they need not be masses:
/// weights that grow towards the pins pass corrections down the cloth instead of back and forth. Each projection starts
/// from a slightly faded correction of the last frame.
class BoundProjection {
 public:
  struct ProjectionLimits {
    double cost = 0.0;  ///< limit of the work, in sweeps over all springs and triangles
    double raw_max_stretch = std::numeric_limits<double>::infinity();  ///< the projection is skipped above this stretch
  };

  BoundProjection(const Layout& layout, double frame_time_s);

  /// Starts from the corrections of the last frame, by solver index, in m, and replaces them by the corrections of this
  /// frame. `confinement` may be null.
  ProjectionResult project(const Layout& layout, const Float4Array& raw, double max_stretch,
                           const ProjectionLimits& limits, Confinement* confinement, ParallelKernels& kernels,
                           Float4Array& corrections);

  /// Returns the result: displacements since the start of the frame by solver index, in m.
  const Float4Array& corrected() const { return corrected_; }

 private:
  double start(const Layout& layout, const Float4Array& raw, const Float4Array& corrections, double raw_ratio,
               Confinement* confinement, ParallelKernels& kernels);
  void end(const Float4Array& raw, ProjectionResult& result, Float4Array& corrections) const;
  double find_max_ratio(const Layout& layout, ParallelKernels& kernels);
  double shorten_long(const Layout& layout, float squared_aim, ParallelKernels& kernels);

  float relaxation_;
  float correction_factor_;  ///< factor on the last frame's correction
  Float4Array corrected_;
  std::vector<float> squared_spring_ratios_;   ///< largest ratios by block
  std::vector<float> squared_surface_ratios_;  ///< largest ratios by block
};

}  // namespace taut::sim::bounded
