#pragma once

#include "sim/contact/bodies.hpp"
#include "sim/solvers/bounded/contact/regions.hpp"

namespace taut::sim::bounded {

/// Bodies as contact sees them: rows that move by exactly what the body moves. A mesh has a row for each of
/// its vertices; planes, spheres and capsules get one for each place where they are near to the cloth.
class BodyContacts {
 public:
  BodyContacts() = default;
  /// `default_friction` is that of bodies without one. Meshes get the rows from `first_row` on.
  BodyContacts(std::vector<Body> bodies, double default_friction, Index first_row);

  /// The triangles of all meshes, by row, and where their vertices are at this time.
  const std::vector<Triangle>& mesh_triangles() const { return mesh_triangles_; }
  std::vector<Vec3> mesh_positions_m(double time_s) const;

  /// Returns a bound on how far any body is off its chord at any time of the span, in m.
  double off_chord_m(const TimeSpan& time) const;

  /// Appends the rows of the meshes, from an origin.
  void add_mesh_rows(const TimeSpan& time, const Vec3& origin_m, RowMoves& rows) const;

  /// Appends what triangles of the cloth could come nearer than the thickness to bodies that are no meshes,
  /// and the rows of those.
  void add_near(std::span<const Triangle> cloth, float thickness_m, const TimeSpan& time, const Vec3& origin_m,
                RowMoves& rows, std::vector<ContactPair>& pairs);

  /// Returns whether the row is a body's.
  bool has(Index row) const { return row >= first_row_; }
  /// Returns which body has the row, by its place among them; of rows near to it, as they were appended last.
  std::size_t body_of(Index row) const;
  /// Returns the friction against the mesh that the row is a vertex of.
  float friction_of(Index row) const { return frictions_[body_of_row_[row - first_row_]]; }

  bool are(const std::vector<Body>& bodies) const { return bodies == bodies_; }

 private:
  std::vector<Body> bodies_;
  std::vector<float> frictions_;  ///< per body
  Index first_row_ = 0;
  std::vector<std::size_t> body_of_row_;  ///< of the meshes' rows
  std::vector<Triangle> mesh_triangles_;
  std::vector<std::size_t> near_ends_;  ///< per body, where the rows end that were appended last
};

}  // namespace taut::sim::bounded
