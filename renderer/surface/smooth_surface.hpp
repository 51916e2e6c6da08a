#pragma once

#include <optional>
#include <vector>

#include "renderer/surface/refined_mesh.hpp"
#include "renderer/surface/rim.hpp"

namespace taut::renderer {

/// A smooth surface through the vertices of a mesh, as a finer mesh. It is made once from the mesh at rest
/// and follows the mesh from frame to frame.
///
/// Midpoints of edges lie on the cubic curves of curved PN triangles (Vlachos and others 2001), again and
/// again; those of borders on curves through four border vertices (Dyn, Levin and Gregory 1987), so that a
/// border stays one curve. Borders end in their corners.
class SmoothSurface {
 public:
  /// most_bulge: how far the surface may leave the coarse triangles, in the unit of positions; along a border
  /// within the surface it may be more. Two surfaces twice that apart do not meet. rim_radius: of the lip
  /// along the border; 0: none.
  SmoothSurface(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles,
                int levels, float most_bulge, float rim_radius = 0.0F);

  /// Without the rim.
  const RefinedMesh& mesh() const { return mesh_; }
  /// Those of mesh() and then those of the rim, three vertices each.
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  /// For each triangle, the coarse one it lies in or, of the rim, at whose border it is.
  const std::vector<std::uint32_t>& parent_triangles() const { return parent_triangles_; }
  /// For each vertex that was added, in this order, two that come before it, of the rim twice the same.
  const std::vector<VertexPair>& parents() const { return parents_; }

  /// Fills positions and normals for coarse vertices at these positions, one for each. Coarse vertices are
  /// taken over as they are.
  void place(std::span<const glm::vec3> coarse_positions);
  /// One for each vertex of mesh() and then of the rim; the normals have unit length.
  const std::vector<glm::vec3>& positions() const { return positions_; }
  const std::vector<glm::vec3>& normals() const { return normals_; }

 private:
  void place(const RefinedMesh::Level& level, float most_bulge);

  std::vector<std::uint32_t> coarse_triangles_;
  RefinedMesh mesh_;
  float most_bulge_;
  std::optional<Rim> rim_;
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> parent_triangles_;
  std::vector<VertexPair> parents_;
  std::vector<glm::vec3> positions_;
  std::vector<glm::vec3> normals_;
};

}  // namespace taut::renderer
