#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// A surface cut into sheets: at most two triangles at every edge, one fan at every vertex, neighbours that face the
/// same side.
struct Sheets {
  sim::Mesh mesh;                    ///< triangles in their order, some turned; vertices at cuts are duplicated
  std::vector<sim::Index> sheet_of;  ///< sheet of each triangle; sheets are numbered by their first triangle
  sim::Index count = 0;
  /// Per corner, three to a triangle: the triangle beyond the side from this corner to the next, or none.
  std::vector<sim::Index> beyond;
};

/// Cuts a mesh where three or more triangles meet: the two across which the surface continues most smoothly stay
/// together. Cuts one-sided surfaces where the sides meet.
Sheets cut_into_sheets(const sim::Mesh& mesh);

/// Returns unit normals of triangles; 0 for a triangle without area.
std::vector<sim::Vec3> unit_normals(const sim::Mesh& mesh);

/// Turns sheets so that they face outwards: closed ones by their volume, open ones to the side that sees less of the
/// garment.
void turn_outwards(Sheets& sheets);

/// Per triangle, the triangle of the other wall of the same cloth: within some 12 mm inwards, facing the other way;
/// none where there is one wall. Requires sheets that face outwards.
using OtherWalls = std::vector<sim::Index>;
OtherWalls find_other_walls(const Sheets& sheets);

/// Returns the fraction of the area that has another wall.
double share_of_two_walls(const Sheets& sheets, const OtherWalls& other);

/// Chooses one wall of cloth that has two, and the larger of sheets that lie on each other. Returns 1 for each triangle
/// that is kept. Requires sheets that face outwards.
std::vector<char> choose_walls(const Sheets& sheets, const OtherWalls& other);

}  // namespace taut::app
