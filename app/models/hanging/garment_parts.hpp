#pragma once

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {

/// A connected run of border edges, such as a neckline, a cuff or a hem. An open seam, whose borders lie face to face,
/// is no opening and ends none.
struct Opening {
  std::vector<sim::Index> vertices;  ///< ascending
  double length_m = 0.0;
  double mean_height_m = 0.0;  ///< mean height of its vertices
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

  /// Returns the axis across the shoulders: 0 or 2, along which the part is larger.
  int across() const { return range.size().z > range.size().x ? 2 : 0; }
  /// Returns its size along that axis.
  double width_m() const { return range.size()[across()]; }
  /// Returns its largest size along any axis.
  double size_m() const { return range.size()[sim::long_axis(range)]; }
};

/// Returns the connected parts, ordered by their first vertex. Requires the adjacency of this mesh.
std::vector<GarmentPart> find_garment_parts(const sim::Mesh& mesh, const sim::Adjacency& adjacency);

/// Returns the openings that are no holes or faults. The pointers are valid as long as the part exists.
std::vector<const Opening*> large_openings(const GarmentPart& part);

/// Returns whether the part hangs in balance when it is held over this range: seen from above, its centre of mass lies
/// within the range or hardly beside it.
bool carries(const GarmentPart& part, const sim::Extent& held);

/// Returns whether an opening is as far out as the cuffs of arms that are stretched out.
bool has_sleeves(const GarmentPart& part);

/// Returns the highest level opening that carries an upright part; nullptr if there is none. A part's only border is
/// its outline and no opening.
const Opening* top_opening(const GarmentPart& part);

/// Returns the waist of a part that lies flat, the narrowest opening that carries it; nullptr if there is none.
const Opening* inner_opening(const GarmentPart& part);

/// Returns the vertices of the two highest openings that carry the part together, such as the armholes of a
/// dress with straps. Empty if there are none.
std::vector<sim::Index> pair_of_openings(const GarmentPart& part);

}  // namespace taut::app
