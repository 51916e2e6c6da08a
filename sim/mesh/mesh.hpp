#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// A surface as flat arrays. Positions are in metres, one per vertex; y is up.
struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  /// The cells of a regular grid; empty for a triangle model. Cell q consists of triangles 2q and 2q + 1.
  std::vector<Quad> quads;
  /// Per triangle, where its corners are in the flat piece that it was cut from, in metres: its shape at rest, wherever
  /// `positions` are. Empty: the mesh is at rest in `positions`.
  std::vector<std::array<Vec2, 3>> cut_m = {};
};

/// Returns the corners of a triangle at rest, in metres.
std::array<Vec3, 3> corners_at_rest(const Mesh& mesh, std::size_t triangle);

/// Repairs that weld_and_validate may make.
struct RepairSettings {
  /// Border vertices closer than this are welded, in metres. At 0 only exactly equal positions are welded.
  double weld_distance_m = 0.0;
  /// Parts whose borders lie closer than this are sewn together where that is beyond doubt, in metres
  /// (sim/mesh/sewing.hpp). At 0 none are.
  double sewing_distance_m = 0.0;
};

/// Changes by `weld_and_validate` in a mesh. It repairs nothing silently.
struct MeshReport {
  std::size_t input_vertices = 0;
  std::size_t input_triangles = 0;
  std::size_t welded_vertices = 0;       ///< at exactly the position of an earlier vertex
  std::size_t near_vertices = 0;         ///< welded because they were near enough
  std::size_t sewn_vertices = 0;         ///< at borders of different parts that were sewn together
  std::size_t parted_vertices = 0;       ///< not welded although at equal positions: layers that touch
  std::size_t unused_vertices = 0;       ///< dropped: no remaining triangle uses them
  std::size_t degenerate_triangles = 0;  ///< dropped: two corners alike, or no area
  std::size_t duplicate_triangles = 0;   ///< dropped: the same three positions as an earlier one
  std::size_t turned_triangles = 0;      ///< turned to face the same side as their neighbours
};

/// A repaired mesh and what was repaired.
struct ValidatedMesh {
  Mesh mesh;
  MeshReport report;
  /// Per vertex of the input the vertex of the result that stands for it; `no_vertex` (sim/mesh/welding.hpp) if no
  /// triangle uses the vertex, or only triangles that were dropped.
  std::vector<Index> kept;
};

/// Makes any triangle soup fit to be mapped to springs. It welds vertices at equal positions, drops
/// degenerate and repeated triangles and unused vertices, and turns neighbours to the same side. The order of
/// what remains is kept. Only vertices at a border are welded: a vertex with triangles all around it belongs
/// to another layer of cloth that touches here. Meshes with grid cells are not accepted: they are generated
/// and need no repair. Throws std::invalid_argument on grid cells, on an index out of range, on a position
/// that is not finite and on a mesh in which no triangle remains.
ValidatedMesh weld_and_validate(const Mesh& input, const RepairSettings& settings = {});

/// Returns twice the triangle's area times its unit normal, in m^2.
Vec3 doubled_area_vector(std::span<const Vec3> positions, const Triangle& triangle);

/// Twice the area of a triangle in a plane, above 0 if it is counter-clockwise.
inline double doubled_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Returns whether the triangle is neither a point nor a line.
bool has_area(std::span<const Vec3> positions, const Triangle& triangle);

/// Returns the vector with length 1; 0 stays 0.
inline Vec3 unit_or_zero(const Vec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : Vec3(0.0);
}

/// Returns the sum of the areas of all triangles, in m^2.
double surface_area(const Mesh& mesh);

}  // namespace taut::sim
