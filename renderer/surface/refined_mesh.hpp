#pragma once

#include "prelude.hpp"

namespace taut::renderer {

/// Two vertices, in any order unless said otherwise.
using VertexPair = std::array<std::uint32_t, 2>;

/// A side of a triangle.
struct TriangleSide {
  VertexPair ends;           ///< the lower vertex first
  std::uint32_t number = 0;  ///< three times the triangle plus the corner where it starts
};

/// Returns the corner after this one in its triangle; three corners for each.
inline std::uint32_t next_corner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

/// Returns the sides of all triangles in the order of their ends, those with the same ends in that of their
/// numbers. `triangles` holds three vertices each.
std::vector<TriangleSide> sorted_sides(std::span<const std::uint32_t> triangles);

/// An edge of one triangle alone, and how the border goes on from there.
struct BorderEdge {
  static constexpr std::uint32_t none = ~0U;

  VertexPair ends;                ///< as the triangle goes: counter-clockwise seen from outside
  std::uint32_t side = 0;         ///< three times its triangle plus the corner where it starts
  std::uint32_t previous = none;  ///< the border edge that ends where this one starts
  std::uint32_t next = none;
  std::array<bool, 2> corners{};  ///< whether the border has a corner at each end: no curve goes on there
};

/// Returns the edges that one triangle alone has, in the order of the triangles. Where several borders meet
/// in a vertex none goes on. A corner is where the border turns by more than 45 degrees at rest. `triangles`
/// holds three vertices each.
std::vector<BorderEdge> border_edges(std::span<const glm::vec3> rest_positions,
                                     std::span<const std::uint32_t> triangles);

/// A mesh with each triangle split into four at the midpoints of its edges, `levels` times. The vertices of
/// the coarse mesh keep their numbers. The triangles of coarse triangle t are 4^levels t and those that
/// follow.
class RefinedMesh {
 public:
  /// Requires vertices below the number of positions (asserted). `levels`: 0 to 4.
  RefinedMesh(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles, int levels);

  /// A border edge that is split, with the border vertices around it. At a corner its own end stands for the
  /// one beyond.
  struct BorderCurve {
    std::uint32_t middle = 0;  ///< the vertex that is added
    std::uint32_t before = 0;
    std::uint32_t start = 0;
    std::uint32_t end = 0;
    std::uint32_t after = 0;
  };

  /// Vertices and triangles that one split adds.
  struct Level {
    std::uint32_t first_vertex = 0;  ///< of its midpoints: one for each of `edges`, in this order
    std::vector<VertexPair> edges;   ///< of the mesh before, the lower vertex first, in lexicographic order
    std::vector<BorderCurve> curves;
  };

  const std::vector<Level>& levels() const { return levels_; }
  std::size_t vertex_count() const { return vertex_count_; }
  std::size_t coarse_vertex_count() const { return coarse_vertex_count_; }
  /// Three vertices for each triangle of the fine mesh.
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  /// The border of the fine mesh.
  const std::vector<BorderEdge>& border() const { return border_; }
  /// For each vertex that was added, in this order, the two between which it is. Both come before it.
  const std::vector<VertexPair>& parents() const { return parents_; }
  /// Replaces pairs of coarse vertices by pairs of fine ones along the same edges. Two that have no edge
  /// stay.
  std::vector<VertexPair> refined_edges(std::span<const VertexPair> edges) const;

 private:
  void split();
  void split_border(const std::vector<std::uint32_t>& midpoints, Level& level);

  std::size_t coarse_vertex_count_;
  std::size_t vertex_count_;
  std::vector<Level> levels_;
  std::vector<std::uint32_t> triangles_;
  std::vector<BorderEdge> border_;
  std::vector<VertexPair> parents_;
};

/// Appends to `values`, one for each coarse vertex, the mean of its two parents for every vertex that was
/// added.
template <class Value> void interpolate(std::span<const VertexPair> parents, std::vector<Value>& values) {
  values.reserve(values.size() + parents.size());
  for (const VertexPair& pair : parents) values.push_back(0.5F * (values[pair[0]] + values[pair[1]]));
}

/// Returns the values at the corners of the fine triangles, three each, from those of the coarse ones:
/// linear within each coarse triangle, so that what differs across an edge still does.
template <class Value> std::vector<Value> refined_corner_values(std::span<const Value> corners, int levels) {
  std::vector<Value> values(corners.begin(), corners.end());
  for (int level = 0; level < levels; ++level) {
    std::vector<Value> finer;
    finer.reserve(4 * values.size());
    for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
      const Value &a = values[i], &b = values[i + 1], &c = values[i + 2];
      const Value ab = 0.5F * (a + b), bc = 0.5F * (b + c), ca = 0.5F * (c + a);
      finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
    }
    values = std::move(finer);
  }
  return values;
}

/// Edges shorter than this in the picture need not be halved: what is drawn finer is hardly seen.
inline constexpr float shortest_split_px = 8.0F;

/// Returns how often edges of this length in pixels of the picture have to be halved, for a mesh of so many
/// triangles.
int refinement_levels(float edge_px, std::size_t triangles, float shortest_px = shortest_split_px);

/// Returns the edges along which a mesh is sewn. With texture coordinates, three for each triangle: those at
/// which they differ between two triangles. Without: those at which two triangles meet at more than 50
/// degrees at rest.
std::vector<VertexPair> seam_edges(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles,
                                   std::span<const glm::vec2> corner_coordinates = {});

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
