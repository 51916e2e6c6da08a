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

/// Turns sheets so that they face outwards: closed ones by their volume, open ones to where they see less of
/// the garment.
void turn_outwards(Sheets& sheets);

/// By triangle, the triangle of the other wall of the same cloth: within some 12 mm on the way inwards,
/// facing the other way; none where there is one wall. Requires sheets that face outwards.
using OtherWalls = std::vector<sim::Index>;
OtherWalls find_other_walls(const Sheets& sheets);

/// The share of all area that has another wall.
double share_of_two_walls(const Sheets& sheets, const OtherWalls& other);

/// Chooses one wall of cloth that has two, and of sheets that lie on each other the larger. Returns 1 for
/// each triangle that is kept. Requires sheets that face outwards.
std::vector<char> choose_walls(const Sheets& sheets, const OtherWalls& other);

}  // namespace taut::app
