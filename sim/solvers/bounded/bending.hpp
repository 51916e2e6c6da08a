#pragma once

#include "sim/pins.hpp"
#include "sim/solvers/bounded/kernels/kernels.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim::bounded {

/// The bending of a garment, shared among several levels of detail.
///
/// The rate of the shortest waves grows with one over the square of the edge length. At 85 000 triangles they
/// would need about seventy evaluations per frame, for ripples of half a centimetre that nobody sees. So
/// elements are softened until no wave is too fast for the evaluations. The rigidity they lose is given to
/// elements between clusters of vertices, where the same rigidity makes slower waves. This is repeated with
/// larger clusters until no rigidity is left over. Folds wider than a few clusters meet the whole rigidity.
/// Ripples meet as much as the time between two evaluations allows.
class Bending {
 public:
  Bending() = default;

  /// `rigidity_n_m` is the bending rigidity B. Levels are added until no level has waves of an angular
  /// frequency above about `largest_rate_per_s`. `layout` must outlive this object.
  Bending(const Garment& garment, const Pins& pins, const Layout& layout, double rigidity_n_m,
          double largest_rate_per_s);

  /// True if the cloth has no bending rigidity.
  bool empty() const { return levels_.empty(); }
  std::size_t level_count() const { return levels_.size(); }

  /// The highest angular frequency of all levels together, in radians per second.
  double largest_rate_per_s() const { return largest_rate_per_s_; }

  /// Adds the acceleration by bending at `positions`, in m/s^2. Both arrays have one entry per row of the
  /// layout.
  void add_accelerations(const Float4Array& positions, ParallelKernels& kernels, Float4Array& accelerations);

 private:
  struct Level {
    /// -W K without its diagonal: gives accelerations from positions.
    SlicedMatrix matrix;
    /// By row of the next finer level; empty in the finest level.
    std::vector<std::uint32_t> cluster_of;
    /// Each row's fraction of the mass of its cluster; by row of the next finer level.
    std::vector<float> mass_fraction;
    /// One entry per cluster, followed by as many spare rows as a block has.
    Float4Array positions;
    Float4Array accelerations;
  };

  double find_largest_rate_per_s() const;
  std::vector<double> image_of(const std::vector<double>& mode) const;

  std::size_t first_free_row_ = 0;
  std::size_t row_count_ = 0;
  std::vector<Level> levels_;
  double largest_rate_per_s_ = 0.0;
};

}  // namespace taut::sim::bounded
