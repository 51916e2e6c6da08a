#pragma once

#include "sim/mesh/extent.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

struct TreeSurfacePoint {
  double distance_m;  ///< distance from the query point; along a ray it may be below 0
  sim::Index triangle;
  sim::Vec3 place_m;
};

/// Returns the fraction of the way from a to b at which the segment is nearest to the point.
double share_along(const sim::Vec3& point, const sim::Vec3& a, const sim::Vec3& b);

/// Condition for the points that a search may return.
using AcceptPoint = std::function<bool(const TreeSurfacePoint&)>;
/// Accepts every point.
inline bool accept_all(const TreeSurfacePoint& /*point*/) { return true; }

/// Finds points of a surface that are near a point or hit by a ray, with a tree of boxes in double precision. Of points
/// at equal distances it finds the one of the first triangle, so that every machine finds the same. A triangle with two
/// equal corners is a segment.
class SurfaceTree {
 public:
  SurfaceTree(std::span<const sim::Vec3> positions_m, std::span<const sim::Triangle> triangles);

  /// Returns the nearest accepted point closer than `reach_m`. Adds the number of tested triangles to `looks`.
  std::optional<TreeSurfacePoint> find_nearest(const sim::Vec3& from_m, double reach_m, const AcceptPoint& accept,
                                               std::size_t* looks = nullptr) const;
  /// Returns the first accepted point of the ray between these two distances. Requires a unit direction.
  std::optional<TreeSurfacePoint> first_hit(const sim::Vec3& from_m, const sim::Vec3& direction, double begin_m,
                                            double end_m, const AcceptPoint& accept) const;

 private:
  struct SurfaceTreeNode {
    sim::Extent extent;
    sim::Index begin, end;  ///< range of `order_`
    sim::Index second = 0;  ///< index of the second child, 0 for a leaf; the first child is the next node
  };
  using Corners = std::array<sim::Vec3, 3>;

  void build(sim::Index begin, sim::Index end, std::span<const sim::Vec3> middles_m);
  /// Calls `look` with each triangle whose boxes are within `reach`, nearer boxes first. `reach` may shrink meanwhile.
  template <class DistanceTo, class Look>
  void search(const DistanceTo& distance_to, const double& reach, const Look& look) const;

  std::vector<Corners> corners_;   ///< corners of each triangle
  std::vector<sim::Index> order_;  ///< triangles in the order of the nodes
  std::vector<SurfaceTreeNode> nodes_;
};

/// A point bound to a triangle of a mesh by a position in the triangle and an offset in axes that turn with it.
struct Bond {
  sim::Index triangle = 0;              ///< index of a triangle of the mesh
  std::array<double, 3> weights{};      ///< weights of the triangle's corners at the nearest point; their sum is 1
  sim::Vec3 offset_m = sim::Vec3(0.0);  ///< along the first edge, across it, along the normal
};

/// Binds each point to the nearest triangle of the mesh. With `normals`, one unit vector or 0 for each point, a
/// triangle that faces the same way is preferred at up to twice the distance. Requires a mesh with triangles.
std::vector<Bond> bonds_to(std::span<const sim::Vec3> points_m, const sim::Mesh& mesh,
                           std::span<const sim::Vec3> normals = {});

/// Returns per vertex of a model the part that stays rigid, by one of its vertices: a small part outside the wall, such
/// as a button. Other vertices have none. `is_wall` marks the triangles of the wall.
std::vector<sim::Index> find_rigid_parts(const sim::Mesh& model, std::span<const std::uint8_t> is_wall);

/// Binds the vertices of a model to the mesh that was fitted to it. Each is bound near its neighbours, so that it
/// follows its own layer where layers touch or cross. Rigid parts are bound at one point. `is_wall` marks the triangles
/// of the model that the mesh was made of. Requires triangles in both.
std::vector<Bond> bonds_of_model(const sim::Mesh& model, std::span<const std::uint8_t> is_wall, const sim::Mesh& mesh);

/// Returns the bound points for positions of the mesh's vertices, in m. They are where they were, up to rounding, for
/// the positions at which they were bound. Bonds of bonds_of_model() need fitting::normal_smoothing_rounds.
std::vector<sim::Vec3> follow(std::span<const Bond> bonds, std::span<const sim::Vec3> positions_m,
                              std::span<const sim::Triangle> triangles, int smoothing_rounds = 0);

/// Returns the points of the mesh to which points are bound, in m.
std::vector<sim::Vec3> find_feet(std::span<const Bond> bonds, std::span<const sim::Vec3> positions_m,
                                 std::span<const sim::Triangle> triangles);

/// Returns the vertex of the bond's triangle that has the largest weight.
sim::Index find_nearest_corner(const Bond& bond, std::span<const sim::Triangle> triangles);

/// Returns the mean length of the edges of a mesh with triangles.
double mean_edge_m(const sim::Mesh& mesh);

/// Returns area-weighted unit normals of vertices; 0 at a vertex without a triangle that has an area. Each round of
/// smoothing averages them over the triangles about a vertex.
std::vector<sim::Vec3> vertex_normals(std::span<const sim::Vec3> positions_m, std::span<const sim::Triangle> triangles,
                                      int smoothing_rounds = 0);

}  // namespace taut::app
