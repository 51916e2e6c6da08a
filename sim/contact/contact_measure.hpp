#pragma once

#include "sim/contact/bodies.hpp"
#include "sim/contact/triangle_pair.hpp"
#include "sim/contact/triangle_tree.hpp"
#include "sim/mesh/adjacency.hpp"

namespace taut::sim {

/// Measured contact of one shape.
struct MeasuredContact {
  /// Smallest distance in m of two triangles that share no vertex, or of a triangle and a body: 0 if they cross, below
  /// 0 inside a plane, sphere or capsule, infinite if nothing is within reach.
  double min_distance_m = std::numeric_limits<double>::infinity();
  /// Number of crossing triangle pairs, including pairs that share a vertex or an edge (triangle_pair.hpp), plus the
  /// triangles that enter each plane, sphere and capsule.
  std::size_t crossing_pairs = 0;
};

/// Measures contact of the cloth with itself and with bodies. It uses positions alone: neither solvers nor earlier
/// shapes affect the result.
class ContactMeasure {
 public:
  /// The tree of boxes is built at `positions_m`.
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
  std::vector<TriangleTree> body_trees_;  ///< trees of the bodies that are meshes, in their order
  std::vector<Vec3> areas_m2_;            ///< doubled area vector by triangle
  CompressedRows vertex_triangles_;       ///< triangles by vertex, in ring order if they form a fan
  /// Ring of neighbours by vertex; the first is repeated at the end if the fan closes. Empty if the triangles form no
  /// fan.
  CompressedRows ring_vertices_;
  std::vector<TriangleCouple> near_;
};

/// Returns whether a triangle enters a plane, sphere or capsule beyond rounding; false for a mesh.
bool enters(const Corners& triangle, const Shape& shape);

/// Returns the distance of a triangle from a plane, sphere or capsule, in m, below 0 inside; infinite for a mesh and
/// beyond the reach.
double shape_distance_m(const Corners& triangle, const Shape& shape, double reach_m);

}  // namespace taut::sim
