#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// A surface cut into sheets: at every edge two triangles at most, at every vertex one fan, neighbours that
/// face the same side.
struct Sheets {
  sim::Mesh mesh;  ///< the triangles in their order, some turned; vertices that were cut stand several times
  std::vector<sim::Index> sheet_of;  ///< by triangle; sheets are numbered by their first triangle
  sim::Index count = 0;
  /// By corner, three to a triangle: the triangle beyond the side from this corner to the next, or none.
  std::vector<sim::Index> beyond;
};

/// Cuts where three or more triangles meet: the two that go on most smoothly stay together. Cuts one-sided
/// surfaces where the sides meet.
Sheets cut_into_sheets(const sim::Mesh& mesh);

/// Unit normals of triangles; 0 where a triangle has no area.
std::vector<sim::Vec3> unit_normals(const sim::Mesh& mesh);

}  // namespace taut::app
