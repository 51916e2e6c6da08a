#pragma once

#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/kernels/float4.hpp"

namespace taut::sim::bounded {

/// The triangles of a surface with their vertices and edges, each once; by row.
struct Primitives {
  std::vector<std::array<Index, 1>> vertices;
  std::vector<Edge> edges;
  std::vector<Triangle> triangles;
};

/// The vertices, edges and triangles that may touch.
struct ContactMesh {
  Primitives cloth;
  Primitives bodies;
};

/// `cloth` and `bodies` are triangles of rows; no row is of both.
ContactMesh make_contact_mesh(std::span<const Triangle> cloth, std::span<const Triangle> bodies);

/// Adds to each row the vectors of area of its triangles, doubled.
void add_normals(std::span<const Triangle> triangles, const Float4Array& positions, Float4Array& normals);

}  // namespace taut::sim::bounded
