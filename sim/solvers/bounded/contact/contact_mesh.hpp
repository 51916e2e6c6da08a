#pragma once

#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/kernels/float4.hpp"

namespace taut::sim::bounded {

/// Triangles of a surface with their vertices and edges, each once, by solver index.
struct Primitives {
  std::vector<std::array<Index, 1>> vertices;
  std::vector<Edge> edges;
  std::vector<Triangle> triangles;
};

/// Primitives that may touch.
struct ContactMesh {
  Primitives cloth;
  Primitives bodies;
};

/// `cloth` and `bodies` are triangles by solver index, with no common indices.
ContactMesh make_contact_mesh(std::span<const Triangle> cloth, std::span<const Triangle> bodies);

/// Adds the doubled area vectors of its triangles to each vertex.
void add_normals(std::span<const Triangle> triangles, const Float4Array& positions, Float4Array& normals);

}  // namespace taut::sim::bounded
