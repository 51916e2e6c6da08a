#pragma once

#include "prelude.hpp"

namespace taut::renderer {

/// Two vertices, in any order unless said otherwise.
using VertexPair = std::array<std::uint32_t, 2>;

/// Side of a triangle.
struct TriangleSide {
  VertexPair ends;           ///< the lower vertex first
  std::uint32_t number = 0;  ///< three times the triangle plus the corner where it starts
};

/// Returns the next corner in the same triangle; corners are numbered three per triangle.
inline std::uint32_t next_corner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

/// Returns the sides of all triangles ordered by their ends, then by their numbers. `triangles` holds three vertices
/// each.
std::vector<TriangleSide> sorted_sides(std::span<const std::uint32_t> triangles);

/// Border edge, which belongs to one triangle only, linked to its neighbours.
struct LinkedBorderEdge {
  static constexpr std::uint32_t none = ~0U;

  VertexPair ends;                ///< ends in the triangle's direction: counter-clockwise seen from outside
  std::uint32_t side = 0;         ///< three times its triangle plus the corner where it starts
  std::uint32_t previous = none;  ///< the border edge that ends where this one starts
  std::uint32_t next = none;
  std::array<bool, 2> corners{};  ///< corners of the border at each end: curves end there
};

/// Returns the edges of exactly one triangle, in the order of the triangles. Edges are not linked at vertices where
/// several borders meet. A corner is a turn of more than 45 degrees at rest. `triangles` holds three vertices each.
std::vector<LinkedBorderEdge> border_edges(std::span<const glm::vec3> rest_positions,
                                           std::span<const std::uint32_t> triangles);

/// Mesh with each triangle split into four at the midpoints of its edges, `levels` times. Coarse vertices keep their
/// numbers. The fine triangles of coarse triangle t start at 4^levels t.
class RefinedMesh {
 public:
  /// Requires vertices below the number of positions (asserted). `levels`: 0 to 4.
  RefinedMesh(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles, int levels);

  /// Split border edge with the border vertices around it. At a corner its own end replaces the vertex beyond.
  struct BorderCurve {
    std::uint32_t middle = 0;  ///< added vertex
    std::uint32_t before = 0;
    std::uint32_t start = 0;
    std::uint32_t end = 0;
    std::uint32_t after = 0;
  };

  /// Vertices and triangles that one split adds.
  struct SplitLevel {
    std::uint32_t first_vertex = 0;  ///< first midpoint; one for each of `edges`, in this order
    std::vector<VertexPair> edges;   ///< edges of the mesh before, the lower vertex first, in lexicographic order
    std::vector<BorderCurve> curves;
  };

  const std::vector<SplitLevel>& levels() const { return levels_; }
  std::size_t vertex_count() const { return vertex_count_; }
  std::size_t coarse_vertex_count() const { return coarse_vertex_count_; }
  /// Three vertices for each triangle of the fine mesh.
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  /// The border of the fine mesh.
  const std::vector<LinkedBorderEdge>& border() const { return border_; }
  /// Two earlier vertices per added vertex, in this order; it is their midpoint.
  const std::vector<VertexPair>& parents() const { return parents_; }
  /// Returns the fine edges along coarse edges. Pairs without an edge stay.
  std::vector<VertexPair> refined_edges(std::span<const VertexPair> edges) const;

 private:
  void split();
  void split_border(const std::vector<std::uint32_t>& midpoints, SplitLevel& level);

  std::size_t coarse_vertex_count_;
  std::size_t vertex_count_;
  std::vector<SplitLevel> levels_;
  std::vector<std::uint32_t> triangles_;
  std::vector<LinkedBorderEdge> border_;
  std::vector<VertexPair> parents_;
};

/// Appends to `values`, one per coarse vertex, the mean of both parents for every added vertex.
template <class Value> void interpolate(std::span<const VertexPair> parents, std::vector<Value>& values) {
  values.reserve(values.size() + parents.size());
  for (const VertexPair& pair : parents) values.push_back(0.5F * (values[pair[0]] + values[pair[1]]));
}

/// Returns corner values of the fine triangles, three each, interpolated linearly within each coarse triangle. Values
/// that differ across an edge still do.
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

/// Shortest edge in the picture that is worth halving.
inline constexpr float min_split_px = 12.0F;

/// Returns the number of halvings for edges of this length in pixels of the picture, in a mesh of this many triangles.
int refinement_levels(float edge_px, std::size_t triangles, float min_edge_px = min_split_px);

/// Returns the seam edges of a mesh. With texture coordinates, three for each triangle: edges at which they differ
/// between two triangles. Without: edges at which two triangles meet at more than 50 degrees at rest.
std::vector<VertexPair> seam_edges(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles,
                                   std::span<const glm::vec2> corner_coordinates = {});

/// Largest distance of a rim from the border that it is at, in its radii.
inline constexpr float rim_depth_radii = 2.0F;

/// Rounded lip along the border of a mesh, which shows the thickness of the cloth. It turns from the outside to the
/// inside, with added rings of vertices.
class Rim {
 public:
  /// `radius`: half of the thickness, in the unit of positions. Above 0.
  Rim(const RefinedMesh& mesh, float radius);

  /// Border vertex of each added vertex's ring, twice.
  const std::vector<VertexPair>& parents() const { return parents_; }
  /// Triangles of three vertices each; mesh vertices come before added ones.
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  /// Mesh triangle at whose border each triangle is.
  const std::vector<std::uint32_t>& at_triangles() const { return at_triangles_; }

  /// Fills the entries after the mesh vertices. `slacks`: largest distance of the lip from each vertex of the mesh.
  /// The lip is thinner where its own depth would be more.
  void place(std::span<glm::vec3> positions, std::span<glm::vec3> normals, std::span<const float> slacks);

 private:
  struct Edge {
    VertexPair ends;
    VertexPair rings;  // ring number at each end
  };
  void add_triangles(const Edge& edge, std::uint32_t at_triangle);

  std::uint32_t first_vertex_;
  float radius_;
  std::vector<std::uint32_t> bases_;  // border vertex of each ring
  std::vector<Edge> edges_;
  std::vector<VertexPair> parents_;
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> at_triangles_;
  std::vector<glm::vec3> ways_;  // scratch: border direction at each ring
};

}  // namespace taut::renderer
