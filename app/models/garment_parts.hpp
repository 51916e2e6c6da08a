#pragma once

#include <vector>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// A connected run of border edges, such as a neckline, a cuff or a hem. A seam that was left open, whose
/// borders lie face to face, is none and ends none.
struct Opening {
  std::vector<sim::Index> vertices;  ///< ascending
  double length_m = 0.0;
  double mean_height_m = 0.0;  ///< of its vertices
  sim::Extent range;
};

/// A connected part of a garment.
struct GarmentPart {
  std::vector<sim::Index> vertices;  ///< ascending
  std::vector<sim::Index> triangles;
  std::vector<Opening> openings;  ///< ordered by their first vertex
  sim::Extent range;
  double area_m2 = 0.0;
  sim::Vec3 centre_m = {0.0, 0.0, 0.0};  ///< centre of mass of its surface

  /// The axis across the shoulders: 0 or 2, along which it is larger.
  int across() const { return range.size().z > range.size().x ? 2 : 0; }
  /// Its size along that axis.
  double width_m() const { return range.size()[across()]; }
  /// Its largest size along any axis.
  double size_m() const { return range.size()[sim::longest_axis(range)]; }
};

/// Returns the connected parts, ordered by their first vertex. Requires the adjacency of this mesh.
std::vector<GarmentPart> parts_of(const sim::Mesh& mesh, const sim::Adjacency& adjacency);

}  // namespace taut::app
