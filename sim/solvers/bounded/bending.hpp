#pragma once

#include <vector>

#include "sim/pins.hpp"
#include "sim/solvers/bounded/kernels/kernels.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim::bounded {

/// The bending of a garment, shared among levels of detail.
///
/// The rate of the shortest waves grows with one over the square of the edge length: at 85 000 triangles they
/// would ask for some seventy evaluations a frame, to follow ripples of half a centimetre that nobody sees.
/// So elements are softened until no wave is faster than can be followed, and what that takes from their
/// rigidity is given to elements between clusters of vertices, where the same rigidity makes slower waves;
/// and so on until nothing is left over. Folds wider than a few clusters meet the whole rigidity, ripples
/// meet as much as the time between two evaluations allows.
class Bending {
 public:
  Bending() = default;

  /// B = `rigidity_n_m` in N m; no level is left with waves of a higher angular frequency than about
  /// `largest_rate_per_s`. `layout` has to outlive this.
  Bending(const Garment& garment, const Pins& pins, const Layout& layout, double rigidity_n_m,
          double largest_rate_per_s);

  bool empty() const { return levels_.empty(); }
  std::size_t level_count() const { return levels_.size(); }

  /// No mode of all levels together has a higher angular frequency.
  double largest_rate_per_s() const { return largest_rate_per_s_; }

  /// Adds to `accelerations` what bending does at `positions`, both by rows of the layout.
  void add_accelerations(const Float4Array& positions, ParallelKernels& kernels, Float4Array& accelerations);

 private:
  struct Level {
    SlicedMatrix matrix;                    ///< -W K without its diagonal: accelerations from positions
    std::vector<std::uint32_t> cluster_of;  ///< by row of the next finer level; empty in the finest
    std::vector<float> part_of_mass;        ///< likewise
    Float4Array positions;                  ///< of clusters, and as many spare rows as a slice has
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
