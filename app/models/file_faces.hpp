#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// A line of an OBJ that holds for its faces from one on: "g left sleeve", "o shirt", "usemtl denim", "s 1",
/// "mtllib shirt.mtl".
struct FaceSection {
  std::uint32_t first_face = 0;
  std::string line;  ///< without its end
};

/// The faces of a model as its file has them, to be written again.
struct FileFaces {
  std::vector<std::uint32_t> corner_counts;  ///< per face, at least 3
  std::vector<sim::Index> corners;           ///< vertices of the file, face after face
  std::vector<glm::vec2> corner_uv;          ///< texture coordinates, one per corner, or none
  std::vector<FaceSection> sections;         ///< ordered by their faces
  bool has_normals = false;                  ///< the file has some

  bool empty() const { return corner_counts.empty(); }
};

/// The faces of a mesh: cells of grids as quads, so that a file of them maps to the same edges, then
/// triangles. `corner_uv`: three per triangle, or none; requires none of a grid.
FileFaces faces_of(const sim::Mesh& mesh, std::span<const glm::vec2> corner_uv);

}  // namespace taut::app
