#pragma once

#include "sim/mesh/extent.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// A point of a surface.
struct SurfacePoint {
  double distance_m;  ///< from where it was looked for; along a ray it may be below 0
  sim::Index triangle;
  sim::Vec3 place_m;
};

/// The share of the way from a to b at which the segment between them is nearest to the point.
double share_along(const sim::Vec3& point, const sim::Vec3& a, const sim::Vec3& b);

/// Says which triangles may be found, and where.
using AcceptPoint = std::function<bool(const SurfacePoint&)>;

/// Finds what of a surface is near a point or hit by a ray: boxes around boxes, in double precision. Of
/// places equally far away it finds the one of the first triangle, so that every machine finds the same. A
/// triangle with two equal corners stands for a segment.
class SurfaceTree {
 public:
  SurfaceTree(std::span<const sim::Vec3> positions_m, std::span<const sim::Triangle> triangles);

  /// The nearest point that is accepted, closer than `reach_m`. Counts the triangles that it looked at, if asked to.
  std::optional<SurfacePoint> nearest(const sim::Vec3& from_m, double reach_m, const AcceptPoint& accept,
                                      std::size_t* looks = nullptr) const;
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
  /// Calls `look` with each triangle whose boxes are in reach, which may shrink meanwhile, nearer boxes first.
  template <class DistanceTo, class Look>
  void search(const DistanceTo& distance_to, const double& reach, const Look& look) const;

  std::vector<Corners> corners_;   ///< of triangles, in their order
  std::vector<sim::Index> order_;  ///< of triangles, by nodes
  std::vector<Node> nodes_;
};

/// A point bound to a triangle of a mesh: a place in the triangle, and an offset in a frame that turns with it.
struct Bond {
  sim::Index triangle = 0;              ///< of the mesh
  std::array<double, 3> weights{};      ///< of its corners, at the nearest point; their sum is 1
  sim::Vec3 offset_m = sim::Vec3(0.0);  ///< along the first edge, across it, along the normal
};

/// Binds each point to the nearest triangle of the mesh. With `normals`, one unit vector per point or 0, a
/// triangle that faces the same way is preferred to one at up to twice the distance. Requires a mesh with
/// triangles.
std::vector<Bond> bonds_to(std::span<const sim::Vec3> points_m, const sim::Mesh& mesh,
                           std::span<const sim::Vec3> normals = {});

/// Binds the vertices of a model to the mesh that was fitted to it, each near where its neighbours are bound: of
/// layers that touch or cross it follows its own. `is_wall` says which triangles of the model the mesh was made
/// of; others are carried. Requires triangles in both.
std::vector<Bond> bonds_of_model(const sim::Mesh& model, std::span<const std::uint8_t> is_wall, const sim::Mesh& mesh);

/// Returns the bound points for positions of the mesh's vertices, in m. With `shares`, one per bond, only that
/// share of the offset is left. At the positions it was bound at they are where they were, up to rounding, where
/// all of it is left.
std::vector<sim::Vec3> follow(std::span<const Bond> bonds, std::span<const sim::Vec3> positions_m,
                              std::span<const sim::Triangle> triangles, std::span<const float> shares = {});

/// Vertices of a model that are no part of its wall, such as those of an inner wall or of a button. They go with the
/// wall as it is drawn, so that they stay on their side of it.
struct CarriedVertices {
  std::vector<sim::Triangle> wall;   ///< of the model
  std::vector<sim::Index> vertices;  ///< of the model
  std::vector<Bond> bonds;           ///< of `vertices`, to `wall`
};

CarriedVertices carried_vertices(const sim::Mesh& model, std::span<const std::uint8_t> is_wall);

/// Moves the carried vertices to where those of the wall are among these points of the model, in m. `shares`: one per
/// point.
void carry(const CarriedVertices& carried, std::span<const float> shares, std::vector<sim::Vec3>& points_m);

/// Returns the vertex of the bond's triangle that has the largest weight.
sim::Index nearest_corner(const Bond& bond, std::span<const sim::Triangle> triangles);

/// Returns unit normals per vertex, by area; 0 where a vertex has no triangle with an area.
std::vector<sim::Vec3> vertex_normals(std::span<const sim::Vec3> positions_m, std::span<const sim::Triangle> triangles);

}  // namespace taut::app
