#pragma once

#include "sim/contact/bodies.hpp"
#include "sim/solvers/bounded/contact/regions.hpp"

namespace taut::sim::bounded {

/// Bodies in contact: entries ("rows", numbered after the cloth's solver indices) that move exactly like the body. A
/// mesh has one entry per vertex; planes, spheres and capsules have one for each place near the cloth.
class BodyContacts {
 public:
  BodyContacts() = default;
  /// `default_friction` applies to bodies without their own. Mesh vertices get the entries from `first_row` on.
  BodyContacts(std::vector<Body> bodies, double default_friction, Index first_row);

  /// Triangles of all meshes, by entry, and the positions of their vertices at this time.
  const std::vector<Triangle>& mesh_triangles() const { return mesh_triangles_; }
  std::vector<Vec3> mesh_positions_m(double time_s) const;

  /// Returns a bound in m on the distance of any body from its chord, at any time of the span.
  double off_chord_m(const TimeSpan& time) const;

  /// Appends the entries of the meshes, relative to an origin.
  void add_mesh_rows(const TimeSpan& time, const Vec3& origin_m, RowMoves& rows) const;

  /// Appends all pairs of a cloth triangle and a body without a mesh that could come nearer than the thickness, and the
  /// entries of these bodies.
  void add_near(std::span<const Triangle> cloth, float thickness_m, const TimeSpan& time, const Vec3& origin_m,
                RowMoves& rows, std::vector<ContactPair>& pairs);

  /// Returns whether the entry belongs to a body.
  bool has(Index row) const { return row >= first_row_; }
  /// Returns the index of the entry's body. Entries of add_near() count as last appended.
  std::size_t body_at_row(Index row) const;
  /// Returns the friction against a mesh, for one of its vertices.
  float friction_at_row(Index row) const { return frictions_[body_of_row_[row - first_row_]]; }

  bool has_same_bodies(const std::vector<Body>& bodies) const { return bodies == bodies_; }

 private:
  std::vector<Body> bodies_;
  std::vector<float> frictions_;  ///< per body
  Index first_row_ = 0;
  std::vector<std::size_t> body_of_row_;  ///< body index of each mesh vertex
  std::vector<Triangle> mesh_triangles_;
  std::vector<std::size_t> near_ends_;  ///< per body, the end of its entries of the last add_near()
};

}  // namespace taut::sim::bounded
