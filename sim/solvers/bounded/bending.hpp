#pragma once

#include "sim/garment.hpp"
#include "sim/pins.hpp"
#include "sim/solvers/bounded/kernels/kernels.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim::bounded {

/// A flexural spring a-b and a point of the cloth below its middle: the point where the line from a to b crosses the
/// line from a vertex v to one of its neighbours c. In flat cloth the point lies on the spring. In bent cloth it is
/// away from the spring by the deflection
///   delta = (1 - s) x_a + s x_b - (1 - t) x_v - t x_c,   energy = 1/2 B k |delta|^2,
/// with the bending rigidity B. delta is linear in the positions and zero in every flat shape. So bending does not
/// resist shear and does not depend on the mesh resolution (similar to Bergou, Wardetzky, Harmon, Zorin and Grinspun
/// 2006).
struct FlexuralElement {
  std::array<Index, 4> vertices;  ///< a, b, v, c
  std::array<double, 4> weights;  ///< 1 - s, s, -(1 - t), -t
  double stiffness_per_rigidity;  ///< k, in 1/m^2
};

/// Returns one element per flexural spring except springs without cloth below. Under a curvature kappa the point is
/// kappa s (1 - s) l^2 / 2 away from a line of length l. Each element stands for a share of the cloth's area. The
/// shares are scaled so that a sheet of any mesh resists cylindrical bending with B per unit width, averaged over all
/// directions.
std::vector<FlexuralElement> flexural_elements(const Garment& garment);

/// Largest number of vertices in a cluster; it doubles the edge length.
inline constexpr std::size_t max_cluster_vertices = 4;

/// Coarser copy of a garment, made of clusters of about four vertices. A cluster has the mass of its vertices at their
/// centre of mass. Triangles are where three clusters meet.
struct CoarseCloth {
  Garment garment;
  std::vector<Index> cluster_indices;  ///< cluster index per vertex of the finer garment
  /// Fraction of the cluster's mass, per vertex of the finer garment.
  std::vector<double> mass_fraction;
};

/// Groups the vertices of the finer garment into clusters. Clusters start at its vertices in the given `order`, which
/// names each vertex once, and grow along its edges.
CoarseCloth coarsen(const Garment& fine, const std::vector<Index>& order);

/// Bending of a garment, distributed over several levels of detail.
///
/// The rate of the shortest waves grows with one over the square of the edge length. At 85 000 triangles they would
/// need about seventy evaluations per frame, for invisible ripples of half a centimetre. So elements are softened until
/// no wave is too fast for the evaluations. The lost rigidity goes to elements between clusters of vertices, where it
/// makes slower waves. This is repeated with larger clusters until no rigidity is left over. Folds wider than a few
/// clusters meet the whole rigidity, ripples only as much as the time between two evaluations allows.
class Bending {
 public:
  Bending() = default;

  /// `rigidity_n_m` is the bending rigidity B. Levels are added until no level has waves of an angular frequency above
  /// about `max_rate_per_s`. `layout` must outlive this object.
  Bending(const Garment& garment, const Pins& pins, const Layout& layout, double rigidity_n_m, double max_rate_per_s);

  /// Returns whether the cloth has no bending rigidity.
  bool empty() const { return levels_.empty(); }
  std::size_t level_count() const { return levels_.size(); }

  /// Returns the highest angular frequency of all levels together, in radians per second.
  double max_rate_per_s() const { return max_rate_per_s_; }

  /// Adds the acceleration by bending at `positions`, in m/s^2. Both arrays are by solver index.
  void add_accelerations(const Float4Array& positions, ParallelKernels& kernels, Float4Array& accelerations);

 private:
  struct BendingLevel {
    /// -W K without its diagonal, from positions to accelerations.
    SlicedMatrix matrix;
    /// Cluster index by vertex of the next finer level; empty in the finest level.
    std::vector<std::uint32_t> cluster_indices;
    /// Fraction of the cluster's mass by vertex of the next finer level.
    std::vector<float> mass_fraction;
    /// One entry per cluster, then one block of padding.
    Float4Array positions;
    Float4Array accelerations;
  };

  double find_max_rate_per_s() const;
  std::vector<double> apply_bending(const std::vector<double>& mode) const;

  std::size_t first_free_row_ = 0;
  std::size_t row_count_ = 0;
  std::vector<BendingLevel> levels_;
  double max_rate_per_s_ = 0.0;
};

}  // namespace taut::sim::bounded
