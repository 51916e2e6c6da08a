#pragma once

#include "app/garments/fitting/following.hpp"
#include "sim/contact/triangle_tree.hpp"
#include "sim/garment.hpp"
#include "sim/measures.hpp"
#include "sim/untangle/untangle.hpp"

namespace taut::app {

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
  /// `max_stretch` is a fraction. `rigid_parts` is the result of find_rigid_parts().
  ShapeLimits(const sim::Mesh& model_m, double max_stretch, std::span<const sim::Index> rigid_parts);

  /// Moves these points of the model, in m, as little as is needed: shortens triangles that are stretched more, and
  /// parts triangles that cross. `feet_m` are the points of the simulation mesh that the vertices follow. Both end
  /// after a number of sweeps, even if a limit is not reached.
  void apply(std::span<const sim::Vec3> feet_m, std::vector<sim::Vec3>& points_m) const;

  /// Returns the stretch of the model's edges.
  sim::Stretch measure_stretch(std::span<const sim::Vec3> points_m) const;
  FollowingMeasures measure(std::span<const sim::Vec3> points_m) const;

 private:
  /// Shortens triangles until none is stretched too much, or until the sweeps are used up.
  void shorten(std::vector<sim::Vec3>& points_m) const;
  /// Moves edges and the triangles that they pierce to the sides of each other where they belong.
  void part(std::span<const sim::CrossingPair> crossings, std::span<const sim::Vec3> feet_m,
            std::vector<sim::Vec3>& points_m) const;
  /// Returns the side of the triangle, with this front, where the edge that pierces it belongs: above 0 in front.
  /// Surfaces that are near each other as modelled, such as two walls, keep their sides. Others lie as the simulation
  /// mesh does.
  double find_side(const sim::Piercing& piercing, const sim::Vec3& front, std::span<const sim::Vec3> feet_m) const;
  /// Replaces each vertex of these triangles by a mean of itself and its neighbours.
  void smooth(std::span<const sim::CrossingPair> crossings, std::vector<sim::Vec3>& points_m) const;
  /// Erases the pairs that cross as modelled.
  void erase_own(std::vector<sim::CrossingPair>& pairs) const;
  /// Updates the pairs that cross, in order. Before, they are the pairs at `before_m`, or none if that is empty.
  void update_crossings(std::span<const sim::Vec3> before_m, std::span<const sim::Vec3> points_m,
                        std::vector<sim::CrossingPair>& pairs) const;

  sim::Garment model_;
  sim::TriangleTree tree_;                                ///< tree of its triangles
  sim::CompressedRows triangles_at_;                      ///< triangles by vertex
  double max_ratio_;                                      ///< largest length over rest length, in any direction
  double edge_m_;                                         ///< mean length of an edge
  std::vector<std::uint8_t> is_rigid_;                    ///< per vertex
  std::vector<std::array<sim::Index, 2>> own_crossings_;  ///< pairs that cross as modelled, in order
};

}  // namespace taut::app
