#pragma once

#include <mutex>

#include "app/garments/fitting/following.hpp"
#include "sim/contact/triangle_tree.hpp"
#include "sim/garment.hpp"
#include "sim/measures.hpp"
#include "sim/solvers/bounded/contact/clearances.hpp"

namespace taut::app {

/// Limits the offsets of a model that follows a simulation mesh, so that it stays out of the mesh's next layer.
class OffsetLimits {
 public:
  OffsetLimits(std::span<const Bond> bonds, const sim::Mesh& simulated);

  /// Returns per bond the fraction of its offset that is left at these positions, in m. The fraction is 1 if no other
  /// layer is nearer than the offsets of both together, or nearer than at rest. Otherwise the offsets just meet.
  /// Requires the bonds and triangles of the constructor. Threads may call it at the same time.
  std::vector<float> shares(std::span<const Bond> bonds, std::span<const sim::Vec3> positions_m,
                            std::span<const sim::Triangle> triangles) const;

 private:
  float max_reach_m_;           ///< offset beyond which no layer is looked for
  std::vector<float> reach_m_;  ///< largest offset of a bond about each vertex
  std::vector<float> at_rest_;  ///< shares at rest, by which shares are divided
  mutable std::mutex mutex_;
  mutable sim::bounded::Clearances clearances_;  ///< clearances whose searches use memory of their own
};

/// Measures of a model that follows a simulation mesh.
struct FollowingMeasures {
  sim::Stretch stretch;           ///< stretch of its edges
  double surface_p99 = 0.0;       ///< 99th percentile of the surface stretch
  std::size_t crossings = 0;      ///< count of pairs of its triangles that cross
  std::size_t new_crossings = 0;  ///< count of those that do not cross as modelled
};

/// Limits the shape of a model that follows a simulation mesh: its stretch, and the crossings that it does not have as
/// modelled.
class ShapeLimits {
 public:
  /// `max_stretch` is a fraction. Rigid vertices of `carried` are not smoothed.
  ShapeLimits(const sim::Mesh& model_m, double max_stretch, const CarriedVertices& carried);

  /// Moves these points of the model, in m, as little as is needed: shortens triangles that are stretched more, and
  /// smooths the neighbourhood of new crossings. Both end after a number of sweeps, even if a limit is not reached.
  void apply(std::vector<sim::Vec3>& points_m) const;

  FollowingMeasures measure(std::span<const sim::Vec3> points_m) const;

 private:
  /// Shortens triangles until none is stretched too much, or until the sweeps are used up.
  void shorten(std::vector<sim::Vec3>& points_m) const;
  /// Replaces each marked vertex by a mean of itself and its neighbours.
  void smooth(std::span<const std::uint8_t> is_marked, std::vector<sim::Vec3>& points_m) const;
  /// Erases the pairs that cross as modelled.
  void erase_own(std::vector<sim::CrossingPair>& pairs) const;

  /// Returns the pairs that cross, in order.
  std::vector<sim::CrossingPair> find_crossings(std::span<const sim::Vec3> points_m) const;

  sim::Garment model_;
  sim::TriangleTree tree_;                                ///< tree of its triangles
  sim::CompressedRows triangles_at_;                      ///< triangles by vertex
  double max_ratio_;                                      ///< largest length over rest length, in any direction
  std::vector<std::uint8_t> is_rigid_;                    ///< per vertex
  std::vector<std::array<sim::Index, 2>> own_crossings_;  ///< pairs that cross as modelled, in order
};

}  // namespace taut::app
