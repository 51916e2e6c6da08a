#pragma once

#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {

/// The work of one round, in sweeps: the relaxed ones, an exact one, and a look at everything.
inline constexpr double round_sweeps = tuning::relaxed_sweeps + 2.0;

/// The result of a projection onto the bound.
struct ProjectionResult {
  double raw_max_stretch = 0.0;  ///< of springs or triangles, before the projection
  double cost = 0.0;             ///< the work it took, in sweeps over all of them
  double largest_shift_m = 0.0;  ///< the furthest a vertex was moved
  bool kept = false;             ///< none is longer than the bound allows
};

/// A region for each vertex that a correction has to stay in besides the bound. It has to be convex.
class Confinement {
 public:
  virtual ~Confinement() = default;
  /// A correction of displacements `raw` begins, which is expected to be about `expected`.
  virtual void begin(const Float4Array& raw, const Float4Array& expected) = 0;
  /// Where the correction is stuck, what stands in its way is expected to give way.
  virtual void bring_back(Float4Array& displacements, bool is_stuck) = 0;
  /// Returns whether it has cost more than it may, with a projection of so many sweeps.
  virtual bool is_spent(double /*sweeps*/) const { return false; }
};

/// Brings rows nearer to the bound, by a few sweeps over what is longer. `rows` are displacements since the
/// start of the frame, in m.
void shorten_roughly(const Layout& layout, double max_stretch, ParallelKernels& kernels, Float4Array& rows);

/// Returns the factor of over-relaxed sweeps. Below 2 the distance to every shape within the bound can only
/// fall, whatever the weights (Agmon 1954). The best factor for a chain of n springs is 2 / (1 + sin(pi / n))
/// (Young 1954); the weights make chains shorter.
float relaxation_of(const Layout& layout);
/// Returns the stretch that the last correction of a frame aims at, a little within the bound.
double aimed_stretch(double max_stretch);

/// The last correction of a frame: moves the cloth to where no spring, or no triangle in any direction, is
/// longer than the bound.
///
/// Springs no longer than a bound are a convex set of shapes, and so are triangles: a singular value is a
/// norm of a linear function of positions. So correcting the longer ones again and again ends in it wherever
/// the pins allow it (cyclic projection; Bregman 1965). That is so for any weights of the vertices, and this
/// correction need not move as masses do: weights that grow towards the pins hand corrections down the cloth
/// instead of back and forth. The correction of the last frame, a little faded, is where the next one starts.
class BoundProjection {
 public:
  struct Limits {
    double cost = 0.0;  ///< where it stops, in sweeps over all springs and triangles
    double raw_max_stretch = std::numeric_limits<double>::infinity();  ///< it does not begin above
  };

  BoundProjection(const Layout& layout, double frame_time_s);

  /// Starts from the corrections of the last frame, by row, in m, and replaces them by those of this one.
  /// `confinement` may be null.
  ProjectionResult project(const Layout& layout, const Float4Array& raw, double max_stretch, const Limits& limits,
                           Confinement* confinement, ParallelKernels& kernels, Float4Array& corrections);

  /// The result by row: displacements since the start of the frame, in m.
  const Float4Array& corrected() const { return corrected_; }

 private:
  double start(const Layout& layout, const Float4Array& raw, const Float4Array& corrections, double raw_ratio,
               Confinement* confinement, ParallelKernels& kernels);
  void end(const Float4Array& raw, ProjectionResult& result, Float4Array& corrections) const;
  double largest_ratio(const Layout& layout, ParallelKernels& kernels);
  double shorten_long(const Layout& layout, float squared_aim, ParallelKernels& kernels);

  float relaxation_;
  float kept_correction_;  ///< of the last frame's
  Float4Array corrected_;
  std::vector<float> squared_spring_ratios_;   ///< by block
  std::vector<float> squared_surface_ratios_;  ///< by block
};

}  // namespace taut::sim::bounded
