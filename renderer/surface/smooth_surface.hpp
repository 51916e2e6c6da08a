#pragma once

#include "renderer/surface/refined_mesh.hpp"

namespace taut::renderer {

/// How far a smooth surface may leave the triangles of its mesh, in the unit of positions.
struct SurfaceFreedom {
  float most_bulge = 0.0F;  ///< between the vertices; along a border within the surface it may be more
  /// The largest fairing of vertices, which hides unevenness from edge to edge: steps of folds, teeth of
  /// borders.
  float most_fairing = 0.0F;
};

/// A smooth surface along the vertices of a mesh, as a finer mesh. It is made once from the mesh at rest and
/// follows the mesh from frame to frame.
///
/// Vertices are faired (Taubin 1995), those of a border along it.
///
/// Midpoints of edges lie on the cubic curves of curved PN triangles (Vlachos and others 2001), again and
/// again; those of borders on curves through four border vertices (Dyn, Levin and Gregory 1987), so that a
/// border stays one curve. Borders end in their corners.
class SmoothSurface {
 public:
  /// rim_radius: of the lip along the border; 0: none.
  SmoothSurface(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles, int levels,
                const SurfaceFreedom& freedom, float rim_radius = 0.0F);

  /// Gives corners with another value than the first of their vertex a vertex of their own at the same place,
  /// once. `corners`: one for each of triangles(). Returns the value of each vertex.
  std::vector<glm::vec2> part_vertices(std::span<const glm::vec2> corners);

  /// Without the rim.
  const RefinedMesh& mesh() const { return mesh_; }
  /// Triangles of mesh() and then of the rim, three vertices each.
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  /// For each triangle, the coarse one it lies in or, of the rim, at whose border it is.
  const std::vector<std::uint32_t>& parent_triangles() const { return parent_triangles_; }
  /// For each vertex that was added, in this order, two that come before it; of the rim, and of those that
  /// part_vertices() added, twice the same.
  const std::vector<VertexPair>& parents() const { return parents_; }

  /// Fills positions and normals for coarse vertices at these positions, one for each. `rooms`: how far the
  /// surface may leave the triangles around each, in fairing and bulge together; none: as far as it is free.
  /// Layers do not meet that are at each vertex more than twice its room apart. `heights`: how far vertices of mesh()
  /// are moved along their normals, within what is left of the rooms; none: not at all.
  void place(std::span<const glm::vec3> coarse_positions, std::span<const float> rooms = {},
             std::span<const float> heights = {});
  /// One for each vertex of mesh(), then of the rim and then of part_vertices(); the normals have unit
  /// length.
  const std::vector<glm::vec3>& positions() const { return positions_; }
  const std::vector<glm::vec3>& normals() const { return normals_; }

 private:
  void find_neighbours(std::span<const glm::vec3> rest_positions);
  void fair(std::span<const glm::vec3> coarse_positions);
  void place(const RefinedMesh::Level& level);
  void raise(std::span<const glm::vec3> coarse_positions, std::span<const float> rooms, std::span<const float> heights);

  std::vector<std::uint32_t> coarse_triangles_;
  RefinedMesh mesh_;
  SurfaceFreedom freedom_;
  std::vector<VertexPair> neighbours_;   // of a vertex, the vertex first
  std::vector<float> neighbour_shares_;  // of each vertex 1 over their number, or 0
  std::optional<Rim> rim_;
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> parent_triangles_;
  std::vector<VertexPair> parents_;
  std::size_t first_parted_ = 0;  // of positions_
  std::vector<glm::vec3> positions_;
  std::vector<glm::vec3> normals_;
  std::vector<float> rooms_;                               // of each vertex of mesh_, what is left of it
  std::vector<glm::vec3> faired_, means_, flat_, slopes_;  // scratch
  std::vector<float> free_, raised_, areas_;               // scratch
};

/// Small folds of cloth that is shorter in some direction than at rest, where the edges of its mesh are too long to
/// show them. Waves that are fixed in the material run along what is shortened; a slope of 2 sqrt(e) takes up the
/// share e of a length. (Gillette and others 2015 and Chen and others 2021 add wrinkles from the
/// same measure.)
class Wrinkles {
 public:
  /// One vertex per position, three per triangle. `wavelength`: in the unit of positions.
  Wrinkles(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles, float wavelength);

  /// Says at which vertices heights are wanted: `fine_rest_positions` are those of the mesh and then one for each of
  /// `parents`, as RefinedMesh has them.
  void refine(std::span<const glm::vec3> fine_rest_positions, std::span<const VertexPair> parents);

  /// Returns how far each fine vertex is off along its normal, for a mesh at these positions. Valid until the next
  /// call.
  std::span<const float> heights(std::span<const glm::vec3> positions);

 private:
  static constexpr std::size_t waves = 10;
  using PerWave = std::array<float, waves>;

  PerWave squared_slopes_of(std::size_t triangle, std::span<const glm::vec3> positions) const;
  void spread(std::vector<PerWave>& values) const;

  std::array<glm::vec3, waves> ways_;  ///< of length 1, in the material
  std::vector<std::uint32_t> triangles_;
  /// A triangle at rest: `side_b` and `side_c` times a direction are its shares of the two sides.
  struct Plane {
    glm::vec3 side_b, side_c;
    float area;     ///< twice
    PerWave along;  ///< squared length of each wave's direction in the plane; 0 where it runs too much into it
  };
  std::vector<Plane> planes_;
  std::vector<VertexPair> edges_;
  std::vector<VertexPair> parents_;
  std::vector<PerWave> shapes_;  ///< by fine vertex, of a slope of 1
  std::vector<PerWave> slopes_;  ///< by fine vertex
  std::vector<float> weights_, heights_;
  float wavelength_;
};

}  // namespace taut::renderer
