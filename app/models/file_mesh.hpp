#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Relates the vertices of a model file to those of the garment's mesh. Vertices of a file count from 0, mesh
/// after mesh. In a format without shared vertices, such as STL, the corners of the faces are counted
/// instead.
struct FileVertices {
  /// Per vertex of the file, in the mesh; sim::no_vertex if it was dropped.
  std::vector<sim::Index> mesh_vertex;
  bool are_corners = false;  ///< the numbers count corners

  /// The vertex of the mesh for a vertex of the file. Empty if there is none; `why_missing` then says why.
  std::optional<sim::Index> find(std::size_t number) const;
  /// Says that the number is outside the file, or that no face uses this vertex: "found vertex 9, expected
  /// one of the vertices of the file, 0 to 7".
  std::string why_missing(std::size_t number) const;
  /// The first vertex of the file that became this vertex of the mesh. Empty if there is none.
  std::optional<sim::Index> number_of(sim::Index vertex) const;
  /// The range of numbers: "vertices of the file, 0 to 7".
  std::string describe() const;
};

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

/// The comment that such a file begins with.
inline constexpr const char* obj_comment = "# Taut; metres, y up\n";

/// The mesh as a Wavefront OBJ file, with its vertices at `positions`: in metres, one per vertex of the mesh.
/// The file begins with the comment. `number` is a format of fmt; the default keeps every bit of the
/// positions, so that a reader measures the same lengths. `corner_uv` as in faces_of(); equal ones are
/// written once.
std::string obj_text(const sim::Mesh& mesh, std::span<const sim::Vec3> positions,
                     std::span<const glm::vec2> corner_uv = {}, const std::string& comment = obj_comment,
                     const std::string& number = "{}");

/// The same of the faces of a file, with positions per vertex of that file. `normals`: unit vectors, one per
/// vertex, or none.
std::string obj_text(const FileFaces& faces, std::span<const sim::Vec3> positions, std::span<const glm::vec3> normals,
                     const std::string& comment = obj_comment, const std::string& number = "{}");

}  // namespace taut::app
