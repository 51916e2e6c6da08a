#pragma once

#include "sim/mesh/extent.hpp"

namespace taut::app {

/// A point of a surface.
struct SurfacePoint {
  double distance_m;  ///< from where it was looked for; along a ray it may be below 0
  sim::Index triangle;
  sim::Vec3 place_m;
};

/// Says which triangles may be found, and where.
using AcceptPoint = std::function<bool(const SurfacePoint&)>;

/// Finds what of a surface is near a point or hit by a ray: boxes around boxes, in double precision. Of
/// places equally far away it finds the one of the first triangle, so that every machine finds the same. A
/// triangle with two equal corners stands for a segment.
class SurfaceTree {
 public:
  SurfaceTree(std::span<const sim::Vec3> positions_m, std::span<const sim::Triangle> triangles);

  /// The nearest point that is accepted, closer than `reach_m`.
  std::optional<SurfacePoint> nearest(const sim::Vec3& from_m, double reach_m, const AcceptPoint& accept) const;
  /// The first point that is accepted along the ray between these two distances. Requires a unit direction.
  std::optional<SurfacePoint> first_hit(const sim::Vec3& from_m, const sim::Vec3& direction, double begin_m,
                                        double end_m, const AcceptPoint& accept) const;

 private:
  struct Node {
    sim::Extent extent;
    sim::Index begin, end;  ///< in `order_`
    sim::Index second = 0;  ///< the second child, 0 for a leaf; the first child is the next node
  };
  using Corners = std::array<sim::Vec3, 3>;

  void build(sim::Index begin, sim::Index end, std::span<const sim::Vec3> middles_m);

  std::vector<Corners> corners_;   ///< of triangles, in their order
  std::vector<sim::Index> order_;  ///< of triangles, by nodes
  std::vector<Node> nodes_;
};

}  // namespace taut::app
