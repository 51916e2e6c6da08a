#pragma once

#include "renderer/surface/refined_mesh.hpp"

namespace taut::renderer {

/// A rounded lip along the border of a mesh, which makes it look as thick as cloth. It turns from the outside
/// around to the inside, with rings of vertices that are added to those of the mesh.
class Rim {
 public:
  /// radius: half of the thickness, in the unit of positions. Above 0.
  Rim(const RefinedMesh& mesh, float radius);

  /// For each vertex that is added, the border vertex of its ring, twice.
  const std::vector<VertexPair>& parents() const { return parents_; }
  /// Three vertices each; those of the mesh and after them the added ones.
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  /// For each triangle, the number of the mesh's triangle at whose border it is.
  const std::vector<std::uint32_t>& at_triangles() const { return at_triangles_; }

  /// Fills what comes after the vertices of the mesh.
  void place(std::span<glm::vec3> positions, std::span<glm::vec3> normals);

 private:
  struct Edge {
    VertexPair ends;
    VertexPair rings;  // the number of the ring at each end
  };
  void add_triangles(const Edge& edge, std::uint32_t at_triangle);

  std::uint32_t first_vertex_;
  float radius_;
  std::vector<std::uint32_t> bases_;  // the border vertex of each ring
  std::vector<Edge> edges_;
  std::vector<VertexPair> parents_;
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> at_triangles_;
  std::vector<glm::vec3> ways_;  // scratch: of the border at each ring
};

}  // namespace taut::renderer
