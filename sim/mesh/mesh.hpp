#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// A surface as flat arrays. Positions are in metres, one per vertex; y is up.
struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  /// The cells of a regular grid; empty for a triangle model. Cell q consists of triangles 2q and 2q + 1.
  std::vector<Quad> quads;
  /// Per triangle, the corners in the flat panel it was cut from, in metres: its rest shape, independent of
  /// `positions`. Empty: `positions` are the rest shape.
  std::vector<std::array<Vec2, 3>> cut_m = {};
};

/// A surface at one moment: positions per vertex, in metres, and triangles.
struct Surface {
  std::span<const Vec3> positions_m;
  std::span<const Triangle> triangles;
};

/// Two triangles that cross.
struct CrossingPair {
  Index first = 0;           ///< index of a triangle of the cloth
  Index second = 0;          ///< index of a triangle of the cloth above `first`, or of the body
  Vec3 place_m = Vec3(0.0);  ///< a common point of both, rounded
};

/// Returns the positions of a triangle's corners. Requires that they exist.
std::array<Vec3, 3> corner_positions(const Triangle& t, std::span<const Vec3> positions);

/// Returns the corners of a triangle at rest, in metres.
std::array<Vec3, 3> corners_at_rest(const Mesh& mesh, std::size_t triangle);

/// Repairs allowed to weld_and_validate.
struct RepairSettings {
  /// Border vertices closer than this, in metres, are welded. At 0 only equal positions are welded.
  double weld_distance_m = 0.0;
  /// Parts with borders closer than this, in metres, are sewn together if unambiguous (sew_parts). At 0 none are.
  double sewing_distance_m = 0.0;
};

/// Numbers of all changes by `weld_and_validate`.
struct MeshReport {
  std::size_t input_vertices = 0;
  std::size_t input_triangles = 0;
  std::size_t welded_vertices = 0;       ///< welded to an earlier vertex at exactly the same position
  std::size_t near_vertices = 0;         ///< welded to a near vertex
  std::size_t sewn_vertices = 0;         ///< welded at borders of different parts
  std::size_t unwelded_vertices = 0;     ///< not welded despite equal positions: layers that touch
  std::size_t unused_vertices = 0;       ///< dropped: no remaining triangle uses them
  std::size_t degenerate_triangles = 0;  ///< dropped: two corners alike, or no area
  std::size_t duplicate_triangles = 0;   ///< dropped: the same three positions as an earlier one
  std::size_t turned_triangles = 0;      ///< turned to the side of their neighbours
};

/// Repaired mesh with a report.
struct ValidatedMesh {
  Mesh mesh;
  MeshReport report;
  /// Vertex of the result per vertex of the input; `no_vertex` (sim/mesh/welding.hpp) if no remaining triangle uses it.
  std::vector<Index> result_vertices;
};

/// Makes any triangle soup fit for map_to_springs. It welds vertices at equal positions, drops degenerate and duplicate
/// triangles and unused vertices, and orients neighbours to the same side. The order of the rest is kept. Only border
/// vertices are welded: a vertex surrounded by triangles belongs to another layer of cloth that touches here. Throws
/// std::invalid_argument on grid cells, on an index out of range, on a position that is not finite and on a mesh in
/// which no triangle remains.
ValidatedMesh weld_and_validate(const Mesh& input, const RepairSettings& settings = {});

/// Returns twice the triangle's area times its unit normal, in m^2.
Vec3 doubled_area_vector(std::span<const Vec3> positions, const Triangle& triangle);

/// Returns twice the area of a triangle in a plane; above 0 if it is counter-clockwise.
inline double doubled_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Returns whether the triangle is neither a point nor a line.
bool has_area(std::span<const Vec3> positions, const Triangle& triangle);

/// Returns the vector scaled to length 1; 0 stays 0.
inline Vec3 unit_or_zero(const Vec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : Vec3(0.0);
}

/// Returns the sum of the areas of all triangles, in m^2.
double surface_area(const Mesh& mesh);

}  // namespace taut::sim
