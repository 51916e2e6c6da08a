#pragma once

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>

#include "sim/mesh/mesh.hpp"

namespace taut::app {

using Vertex = OpenMesh::VertexHandle;
using Edge = OpenMesh::EdgeHandle;
using Face = OpenMesh::FaceHandle;
using Halfedge = OpenMesh::HalfedgeHandle;

inline std::size_t number(Vertex v) { return static_cast<std::size_t>(v.idx()); }

/// Adds triangles of vertices that the net has.
inline void add_triangles(const std::vector<sim::Triangle>& triangles, OpenMesh::TriConnectivity& net) {
  const auto vertex = [](sim::Index v) { return Vertex(static_cast<int>(v)); };
  for (const auto& [a, b, c] : triangles) net.add_face(vertex(a), vertex(b), vertex(c));
}

inline sim::Triangle to_triangle(const OpenMesh::TriConnectivity& net, Face f) {
  sim::Triangle corners;
  std::size_t k = 0;
  for (const auto v : net.fv_range(f)) corners[k++] = static_cast<sim::Index>(v.idx());
  return corners;
}

inline std::vector<sim::Triangle> to_triangles(const OpenMesh::TriConnectivity& net) {
  std::vector<sim::Triangle> triangles;
  for (const auto f : net.faces()) triangles.push_back(to_triangle(net, f));
  return triangles;
}

/// The two triangles at an inner edge.
struct Diamond {
  Vertex a, b, left, right;  ///< ends of the edge, and the corners opposite it
};

inline Diamond diamond(const OpenMesh::TriConnectivity& net, Edge e) {
  const Halfedge h = net.halfedge_handle(e, 0), o = net.halfedge_handle(e, 1);
  return {net.from_vertex_handle(h), net.to_vertex_handle(h), net.to_vertex_handle(net.next_halfedge_handle(h)),
          net.to_vertex_handle(net.next_halfedge_handle(o))};
}

}  // namespace taut::app
