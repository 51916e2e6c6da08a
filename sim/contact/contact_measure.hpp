#pragma once

#include "sim/contact/bodies.hpp"
#include "sim/contact/triangle_pair.hpp"
#include "sim/contact/triangle_tree.hpp"
#include "sim/mesh/adjacency.hpp"

namespace taut::sim {

/// How near things are in one shape, measured.
struct MeasuredContact {
  /// The distance of the two nearest triangles that share no vertex, or of a triangle from a body, in m: 0 where they
  /// cross, below 0 in a plane, sphere or capsule; infinite where nothing is within the reach.
  double nearest_m = std::numeric_limits<double>::infinity();
  /// Pairs of triangles that cross, also those that share a vertex or an edge (triangle_pair.hpp), and for each plane,
  /// sphere and capsule the triangles that enter it.
  std::size_t crossing_pairs = 0;
};

/// Measures how near cloth is to itself and to bodies, from where it is alone: nothing here is known to solvers, and
/// what is measured does not depend on earlier shapes.
class ContactMeasure {
 public:
  /// `positions_m` is where the mesh is cut into boxes.
  ContactMeasure(std::span<const Triangle> triangles, std::span<const Vec3> positions_m, std::vector<Body> bodies);

  const std::vector<Body>& bodies() const { return bodies_; }

  /// Measures the cloth at `positions_m` among the bodies at that time.
  MeasuredContact measure(std::span<const Vec3> positions_m, double time_s, double reach_m);

 private:
  void make_fans(std::size_t vertices);
  bool lies_open(Index vertex, std::span<const Vec3> positions_m) const;
  std::size_t crossings_around(Index vertex, std::span<const Vec3> positions_m) const;
  void measure_mesh(const Body& body, TriangleTree& tree, std::span<const Vec3> positions_m, double time_s,
                    double reach_m, MeasuredContact& measured);

  std::vector<Triangle> triangles_;
  std::vector<Body> bodies_;
  TriangleTree tree_;
  std::vector<TriangleTree> body_trees_;  ///< of bodies that are meshes, in their order
  std::vector<Vec3> areas_m2_;            ///< by triangle: its area vector, doubled
  CompressedRows triangles_of_;           ///< by vertex, in turn where they are a fan
  /// By vertex: the vertices around its fan, of which the last is the first again where it closes. None where its
  /// triangles are no fan.
  CompressedRows around_;
  std::vector<TriangleCouple> near_;
};

/// Returns the distance of a triangle from a plane, sphere or capsule, in m, below 0 where it enters; infinite for a
/// mesh and beyond the reach.
double shape_distance_m(const Corners& triangle, const Shape& shape, double reach_m);

}  // namespace taut::sim
