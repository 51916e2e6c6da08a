#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// A surface as flat arrays. Positions in metres, y up.
struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  /// Cells of a regular grid, empty for a triangle model. Cell q is made of triangles 2q and 2q + 1.
  std::vector<Quad> quads;
};

struct RepairSettings {
  /// Border vertices closer than this are joined too, m. 0: only where positions are exactly equal.
  double weld_distance_m = 0.0;
};

/// What `weld_and_validate` did to a mesh; nothing is repaired silently.
struct MeshReport {
  std::size_t input_vertices = 0;
  std::size_t input_triangles = 0;
  std::size_t welded_vertices = 0;       ///< had exactly the position of an earlier vertex
  std::size_t near_vertices = 0;         ///< were welded because they were near enough
  std::size_t parted_vertices = 0;       ///< of layers that touch: equal positions, but not welded
  std::size_t unused_vertices = 0;       ///< belonged to no remaining triangle
  std::size_t degenerate_triangles = 0;  ///< two corners alike, or no area
  std::size_t duplicate_triangles = 0;   ///< the same three positions as an earlier triangle
  std::size_t turned_triangles = 0;      ///< so that neighbours agree about which side is outside
};

struct ValidatedMesh {
  Mesh mesh;
  MeshReport report;
};

/// Makes any triangle soup fit to be mapped to springs: vertices at equal positions become one, degenerate
/// and repeated triangles and unused vertices go, neighbours are turned to the same side. The order of what
/// remains is kept. A vertex is welded only where its surface ends: where triangles close around it, another
/// vertex at the same place belongs to another layer of cloth that touches this one.
/// Meshes with grid cells are generated, not read, and are not accepted here.
/// Throws std::invalid_argument on an index out of range, on a position that is not finite and on a mesh
/// in which no triangle remains.
ValidatedMesh weld_and_validate(const Mesh& input, const RepairSettings& settings = {});

/// Twice the triangle's area times its unit normal, in m^2.
Vec3 doubled_area_vector(const std::vector<Vec3>& positions, const Triangle& triangle);

/// Sum of the triangles' areas, in m^2.
double surface_area(const Mesh& mesh);

}  // namespace taut::sim
