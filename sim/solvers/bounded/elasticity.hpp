#pragma once

#include "sim/garment.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/memory.hpp"
#include "sim/solvers/bounded/motion.hpp"

namespace taut::sim::bounded {

/// Symmetric matrix in the plane of a triangle.
struct InPlane {
  float first = 0.0F, second = 0.0F, mixed = 0.0F;
};

/// Tension law of cloth in its plane: strain = tension / stiffness along warp, weft and in shear, for any time step.
///
/// The tension of the load is the impulse of the sweeps of some time steps, over their time. Rest shapes of triangles
/// are longer by the strain of the low-passed tension: strain lags behind tension, like a damper beside each thread,
/// which takes energy out of motion. Rest shapes are also shorter by the error that sweeps leave, so that the loaded
/// cloth reaches the right length; this part is found little by little. Sweeps do all corrections, and cloth at rest
/// does not move in any time step.
class Elasticity {
 public:
  /// Makes no law if the material has none or triangles are not bounded.
  Elasticity(const Garment& garment, const Layout& layout);

  bool has_law() const { return lanes_.block_count() > 0; }

  /// Returns the memory of cloth that starts stretched: the tension of its strain, which is clamped to `most`. Requires
  /// a law and started triangles.
  ElasticMemory at_start(const Layout& layout, double most) const;
  /// Continues from a memory. Requires a law.
  void begin_attempt(const Layout& layout, const StartRows& start, const ElasticMemory& memory, double most,
                     double time_step_s, ParallelKernels& kernels);
  /// Counts a time step.
  void count_step() { ++steps_; }
  /// Updates the rest shapes from the tension and the shape since the last update.
  void follow(const Layout& layout, const Motion& motion, double time_step_s, ParallelKernels& kernels);
  const ElasticMemory& memory() const { return memory_; }
  /// Returns the time steps per second at which the remaining strain error is small.
  double steps_needed_per_s() const;

  /// Triangles with stretched rest shapes.
  const SurfaceLanes& lanes() const { return lanes_; }
  SurfaceLanes& lanes() { return lanes_; }
  /// Corrections by block; null without a law.
  SurfaceSums* sums() { return has_law() ? sums_.data() : nullptr; }

 private:
  /// Angle between the warp and the first edge of each triangle.
  struct alignas(64) Warps {
    std::array<float, block_size> cosine = {};
    std::array<float, block_size> sine = {};
  };

  void stretch_rest_shapes(const Layout& layout, const StartRows& start, ParallelKernels& kernels);
  void update_shortening(const Layout& layout, const Float4Array& moved, double time_s);
  std::vector<InPlane> mean_tension(double time_step_s, double time_s) const;
  void share_with_neighbours(std::vector<InPlane>& values) const;
  /// Returns the approximate strain error per tension that one sweep leaves.
  float sag_m_per_n(std::size_t lane) const { return 2.0F * squared_step_s2_ * lanes_.mobility_per_kg[lane]; }

  std::vector<Material> materials_;
  float squared_step_s2_ = 0.0F;
  SurfaceLanes lanes_;
  std::vector<Warps> warps_;               ///< warp directions by block
  std::vector<float> areas_m2_;            ///< rest area per lane; 0 in padding
  std::vector<std::uint8_t> material_indices_;  ///< material index per lane
  std::vector<SurfaceSums> sums_;          ///< corrections by block
  Float4Array areas_at_rows_m2_;           ///< summed areas of a vertex's triangles, in x
  int steps_ = 0;                          ///< number of time steps in sums_
  ElasticMemory memory_;
  double max_strain_ = 0.0;  ///< largest strain of a rest shape
};

/// Returns the number of rest shape updates per frame.
int tension_updates_per_frame(double frame_time_s);

}  // namespace taut::sim::bounded
