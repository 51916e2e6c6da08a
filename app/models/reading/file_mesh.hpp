#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Maps the vertices of a model file to vertices of the garment's mesh. Vertices of a file count from 0, mesh after
/// mesh. In a format without shared vertices, such as STL, the corners of the faces are counted instead.
struct FileVertices {
  /// Per vertex of the file, its vertex in the mesh; sim::no_vertex if it was dropped.
  std::vector<sim::Index> mesh_vertex;
  bool are_corners = false;  ///< true if the numbers count corners

  /// Returns the mesh's vertex for a vertex of the file; empty if there is none, for a reason that `why_missing` gives.
  std::optional<sim::Index> find(std::size_t number) const;
  /// Returns why a vertex is missing: its number is outside the file, or no face uses it. An example is "found vertex
  /// 9, expected one of the vertices of the file, 0 to 7".
  std::string why_missing(std::size_t number) const;
  /// Returns the first vertex of the file that became this vertex of the mesh; empty if there is none.
  std::optional<sim::Index> number_of(sim::Index vertex) const;
  /// Returns the range of numbers: "vertices of the file, 0 to 7".
  std::string describe() const;
};

/// A line of an OBJ that applies to its faces from `first_face` on: "g left sleeve", "o shirt", "usemtl denim", "s 1",
/// "mtllib shirt.mtl".
struct FaceSection {
  std::uint32_t first_face = 0;
  std::string line;  ///< line without its end
};

/// Faces of a model in the order of its file, to be written again.
struct FileFaces {
  std::vector<std::uint32_t> corner_counts;  ///< per face, at least 3
  std::vector<sim::Index> corners;           ///< indices of vertices of the file, face after face
  std::vector<glm::vec2> corner_uv;          ///< texture coordinates, one per corner, or none
  std::vector<FaceSection> sections;         ///< ordered by their faces
  bool has_normals = false;                  ///< true if the file has normals

  bool empty() const { return corner_counts.empty(); }
};

/// Returns the faces of a mesh: cells of grids as quads, so that a file of them maps to the same edges, then triangles.
/// `corner_uv` has three entries per triangle, or none; requires none for a grid.
FileFaces make_faces(const sim::Mesh& mesh, std::span<const glm::vec2> corner_uv);

/// Comment at the start of an OBJ file.
inline constexpr const char* obj_comment = "# Taut; metres, y up\n";

/// Returns the mesh as a Wavefront OBJ file with its vertices at `positions`: in metres, one per vertex of the mesh.
/// The file begins with the comment. `number` is a format of fmt; the default keeps every bit of the positions, so that
/// a reader measures the same lengths. `corner_uv` is as in make_faces(); equal pairs are written once.
std::string obj_text(const sim::Mesh& mesh, std::span<const sim::Vec3> positions,
                     std::span<const glm::vec2> corner_uv = {}, const std::string& comment = obj_comment,
                     const std::string& number = "{}");

/// Returns the faces of a file as an OBJ likewise, with positions per vertex of that file. `normals` are unit vectors,
/// one per vertex, or none.
std::string obj_text(const FileFaces& faces, std::span<const sim::Vec3> positions, std::span<const glm::vec3> normals,
                     const std::string& comment = obj_comment, const std::string& number = "{}");

}  // namespace taut::app
