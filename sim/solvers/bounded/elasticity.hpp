#pragma once

#include "sim/garment.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/memory.hpp"
#include "sim/solvers/bounded/motion.hpp"

namespace taut::sim::bounded {

/// A symmetric matrix in the plane of a triangle.
struct InPlane {
  float first = 0.0F, second = 0.0F, mixed = 0.0F;
};

/// The law of cloth in its plane: strain = tension / stiffness along warp, weft and in shear, at any length of
/// a time step.
///
/// The tension that the load asks for is the pull of the sweeps of some time steps, over their time. The rest
/// shapes of triangles are longer by the strain that it has by the law, low-passed: strain lags behind tension,
/// as with a damper beside each thread, and takes energy out of motion. They are shorter by what sweeps leave:
/// a tension that sweeps give to cloth of the right length, found little by little. All corrections are those
/// of sweeps, and the cloth at rest moves in no time step.
class Elasticity {
 public:
  /// Has no law where the material has none, or where triangles are not held.
  Elasticity(const Garment& garment, const Layout& layout);

  bool has_law() const { return lanes_.block_count() > 0; }

  /// Returns the memory of cloth that begins stretched: under the tension of that strain, or of `most`. It requires a
  /// law, and triangles that have started.
  ElasticMemory at_start(const Layout& layout, double most) const;
  /// Goes on from a memory, which requires a law.
  void begin_attempt(const Layout& layout, const StartRows& start, const ElasticMemory& memory, double most,
                     double time_step_s, ParallelKernels& kernels);
  /// After a time step.
  void count_step() { ++steps_; }
  /// Makes the rest shapes anew, by the tension and the shape of the time steps since they last were.
  void follow(const Layout& layout, const Motion& motion, double time_step_s, ParallelKernels& kernels);
  const ElasticMemory& memory() const { return memory_; }
  /// Returns how many time steps in a second leave little to hold back.
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
  void hold_back(const Layout& layout, const Float4Array& moved, double time_s);
  std::vector<InPlane> mean_tension(double time_step_s, double time_s) const;
  void share_with_neighbours(std::vector<InPlane>& values) const;
  /// About what a sweep of one time step leaves of a tension, as a strain.
  float sag_m_per_n(std::size_t lane) const { return 2.0F * squared_step_s2_ * lanes_.mobility_per_kg[lane]; }

  std::vector<Material> materials_;
  float squared_step_s2_ = 0.0F;
  SurfaceLanes lanes_;
  std::vector<Warps> warps_;               ///< by block
  std::vector<float> areas_m2_;            ///< per lane, at rest; 0 in padding
  std::vector<std::uint8_t> material_of_;  ///< per lane
  std::vector<SurfaceSums> sums_;          ///< by block
  Float4Array areas_at_rows_m2_;           ///< of the triangles at a row, in x
  int steps_ = 0;                          ///< that sums_ are of
  ElasticMemory memory_;
  double most_ = 0.0;  ///< strain of a rest shape
};

/// Returns how often rest shapes follow tension in a frame.
int follows_in(double frame_time_s);

}  // namespace taut::sim::bounded
