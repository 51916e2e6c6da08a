#pragma once

#include "sim/mesh/groups.hpp"
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

/// Returns the mesh of the triangles that are marked, with all vertices.
sim::Mesh select_triangles(const sim::Mesh& mesh, std::span<const std::uint8_t> is_marked);

/// Returns the triangle's area, in m^2.
inline double triangle_area(std::span<const sim::Vec3> positions_m, const sim::Triangle& t) {
  return 0.5 * glm::length(sim::doubled_area_vector(positions_m, t));
}

/// Returns the mean of the triangle's corners.
inline sim::Vec3 triangle_middle(std::span<const sim::Vec3> positions, const sim::Triangle& t) {
  return (positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3.0;
}

/// Returns six times the volume of the pyramids from a point to these triangles; pyramids on triangles that face the
/// point count below 0. The sum is the solid's if the triangles are a closed surface that faces outwards.
double six_times_volume(const sim::Mesh& mesh, std::span<const sim::Index> triangles, const sim::Vec3& apex);

/// Replaces each vertex of the triangles by the first of its group, and leaves out triangles of which two corners
/// become one. Returns how many were left out.
std::size_t merge_vertices(sim::Groups& groups, std::vector<sim::Triangle>& triangles);

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
std::vector<std::uint8_t> choose_walls(const Sheets& sheets, const OtherWalls& other);

}  // namespace taut::app
