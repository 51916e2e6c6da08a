#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/types.hpp"

namespace taut::sim {

/// A surface as flat arrays. Positions in metres, y up.
struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  /// Cells of a regular grid, empty for a triangle model. Cell q is made of triangles 2q and 2q + 1.
  std::vector<Quad> quads;
};

/// What `weld_and_validate` did to a mesh; nothing is repaired silently.
struct MeshReport {
  std::size_t input_vertices = 0;
  std::size_t input_triangles = 0;
  std::size_t welded_vertices = 0;       ///< had exactly the position of an earlier vertex
  std::size_t unused_vertices = 0;       ///< belonged to no remaining triangle
  std::size_t degenerate_triangles = 0;  ///< two corners alike, or no area
  std::size_t duplicate_triangles = 0;   ///< the same three vertices as an earlier triangle
};

struct ValidatedMesh {
  Mesh mesh;
  MeshReport report;
};

/// Makes any triangle soup fit to be mapped to springs: vertices at exactly equal positions become one,
/// degenerate and repeated triangles and unused vertices go. The order of what remains is kept.
/// Meshes with grid cells are generated, not read, and are not accepted here.
/// Throws std::invalid_argument on an index out of range, on a position that is not finite and on a mesh
/// in which no triangle remains.
ValidatedMesh weld_and_validate(const Mesh& input);

/// Twice the triangle's area times its unit normal, in m^2.
Vec3 doubled_area_vector(const std::vector<Vec3>& positions, const Triangle& triangle);

/// Sum of the triangles' areas, in m^2.
double surface_area(const Mesh& mesh);

}  // namespace taut::sim
