#pragma once

#include "renderer/surface/refined_mesh.hpp"

namespace taut::renderer {

/// Largest distances of a smooth surface from the triangles of its mesh, in the unit of positions.
struct SurfaceFreedom {
  float max_bulge = 0.0F;  ///< bulge between vertices; along a border, where nothing is near, it may be more
  /// Largest fairing of vertices, which hides unevenness from edge to edge: steps of folds, teeth of borders.
  float max_fairing = 0.0F;
};

/// Smooth surface along the vertices of a mesh, as a finer mesh. It is made once from the mesh at rest and follows the
/// mesh from frame to frame.
///
/// Vertices are faired (Taubin 1995), border vertices along the border.
///
/// Midpoints of edges lie on the cubic curves of curved PN triangles (Vlachos and others 2001), at every level.
/// Midpoints of borders lie on curves through four border vertices (Dyn, Levin and Gregory 1987), so that a border
/// stays one curve between its corners.
class SmoothSurface {
 public:
  /// `rim_radius`: radius of the lip along the border; 0: none.
  SmoothSurface(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles, int levels,
                const SurfaceFreedom& freedom, float rim_radius = 0.0F);

  /// Splits vertices whose corners have different values, once, so that each vertex has one value. `corners`: one for
  /// each of triangles(). Returns the value of each vertex.
  std::vector<glm::vec2> part_vertices(std::span<const glm::vec2> corners);

  /// Fine mesh without the rim.
  const RefinedMesh& mesh() const { return mesh_; }
  /// Triangles of mesh() and then of the rim, three vertices each.
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  /// Coarse triangle of each triangle; for the rim, the one at whose border it is.
  const std::vector<std::uint32_t>& parent_triangles() const { return parent_triangles_; }
  /// Two earlier vertices per added vertex, in this order; twice the same for the rim and for split vertices.
  const std::vector<VertexPair>& parents() const { return parents_; }

  /// Fills positions and normals for these coarse positions. `clearances`: the largest distance of the surface, its rim
  /// included, from its triangles around each coarse vertex; none: the freedom of the surface. Layers do not meet if
  /// their distance at each vertex exceeds twice this. `heights`: motion of the vertices of mesh() along their normals,
  /// limited to what the clearances leave; none: no motion.
  void place(std::span<const glm::vec3> coarse_positions, std::span<const float> clearances = {},
             std::span<const float> heights = {});
  /// One per vertex of mesh(), then of the rim, then of part_vertices(); normals have unit length.
  const std::vector<glm::vec3>& positions() const { return positions_; }
  const std::vector<glm::vec3>& normals() const { return normals_; }

 private:
  void find_neighbours(std::span<const glm::vec3> rest_positions);
  void fair(std::span<const glm::vec3> coarse_positions);
  void place(const RefinedMesh::SplitLevel& level);
  void raise(std::span<const float> heights);

  std::vector<std::uint32_t> coarse_triangles_;
  RefinedMesh mesh_;
  SurfaceFreedom freedom_;
  std::vector<VertexPair> neighbours_;   // pairs of a vertex and its neighbour
  std::vector<float> neighbour_shares_;  // 1 / number of neighbours per vertex, or 0
  std::optional<Rim> rim_;
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> parent_triangles_;
  std::vector<VertexPair> parents_;
  std::size_t first_parted_ = 0;  // index of the first split vertex
  std::vector<glm::vec3> positions_;
  std::vector<glm::vec3> normals_;
  std::vector<float> clearances_;                   // remaining bulge per vertex of mesh_
  std::vector<float> slacks_;                       // what the clearances leave, per vertex of mesh_
  std::vector<glm::vec3> faired_, means_, slopes_;  // scratch
  std::vector<float> raised_, areas_;               // scratch
};

}  // namespace taut::renderer
