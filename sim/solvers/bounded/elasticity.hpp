#pragma once

#include <vector>

#include "sim/garment.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/memory.hpp"
#include "sim/solvers/bounded/motion.hpp"

namespace taut::sim::bounded {

/// The law of cloth in its plane: strain = tension / stiffness along warp, weft and in shear, at any length of
/// a time step.
///
/// A sweep answers tension by how long a step is. But no correction of positions alone adds velocity; so what
/// sweeps have pulled in a frame, over its time, is the tension that the load asks for. The rest shapes of
/// triangles follow it, low-passed, by the law: strain lags behind tension, as with a damper beside each
/// thread, and takes energy out of motion. Sweeps hold cloth to these shapes as they hold it to those at rest
/// without a law, and `settle` takes out by which it sags all the same.
class Elasticity {
 public:
  /// Has no law where the material has none, or where triangles are not held.
  Elasticity(const Garment& garment, const Layout& layout);

  bool has_law() const { return lanes_.block_count() > 0; }

  /// Goes on from a memory, which requires a law.
  void begin_attempt(const Layout& layout, const StartRows& start, const ElasticMemory& memory, double most,
                     ParallelKernels& kernels);
  /// After a time step.
  void count_step() { ++steps_; }
  /// Stretches the rest shapes by the tension, low-passed, of the time steps since they last were.
  void follow(const Layout& layout, const StartRows& start, double time_step_s, ParallelKernels& kernels);
  /// Corrects positions, and no velocities, to where triangles are no longer than their rest shapes: by what
  /// the cloth sagged in the last interval, and then by sweeps. Air takes the part `dragged` of velocities in
  /// a time step.
  void settle(double interval_s, double dragged, ParallelKernels& kernels, Motion& motion);
  /// Changes the positions of a time step ago so that cloth moves as it does over all, without what it sags from
  /// one settling to the next.
  void take_out_sagging(double time_step_s, Float4Array& previous) const;
  const ElasticMemory& memory() const { return memory_; }
  /// Returns how many time steps in a second leave little of the tension to `settle`.
  double steps_needed_per_s() const;

  /// The triangles with their rest shapes stretched.
  const SurfaceLanes& lanes() const { return lanes_; }
  SurfaceLanes& lanes() { return lanes_; }
  /// By block; null without a law.
  SurfaceSums* sums() { return has_law() ? sums_.data() : nullptr; }

 private:
  /// The angle of the warp to the first edges of triangles.
  struct alignas(64) Warps {
    std::array<float, block_size> cosine = {};
    std::array<float, block_size> sine = {};
  };

  void stretch_rest_shapes(const Layout& layout, const StartRows& start, ParallelKernels& kernels);
  Float4Array smoothed(double time_step_s, double time_s) const;

  Material material_;
  float relaxation_ = 1.0F;  ///< of settling
  SurfaceLanes lanes_;
  std::vector<std::uint32_t> all_blocks_;
  std::vector<Warps> warps_;           ///< by block
  std::vector<float> areas_m2_;        ///< per lane, at rest; 0 in padding
  std::vector<SurfaceSums> sums_;      ///< by block
  Float4Array areas_at_rows_m2_;       ///< of the triangles at a row, in x
  int steps_ = 0;                      ///< that sums_ are of
  ElasticMemory memory_;
  double most_ = 0.0;                  ///< strain of a rest shape
  Float4Array before_;                 ///< by row
};

/// Returns how often rest shapes follow tension in a frame.
int follows_in(double frame_time_s);

}  // namespace taut::sim::bounded
