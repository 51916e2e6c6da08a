#pragma once

#include "app/models/garment_loading.hpp"

namespace taut::app {

/// Where a surface is cut.
struct CuttingPlane {
  sim::Vec3 point_m = {0.0, 0.0, 0.0};
  sim::Vec3 normal = {0.0, 1.0, 0.0};  ///< of length 1
};

/// A curve that a plane cuts out of a surface.
struct SectionCurve {
  /// Along the curve, in the plane, in m from its point. Of a level plane: x, and z backwards.
  std::vector<sim::Vec2> points_m;
  bool is_closed = false;
};

/// Returns the curves that the plane cuts out of the surface. Where more than two triangles meet at an edge
/// that is cut, curves end.
std::vector<SectionCurve> section_of(const Surface& surface, const CuttingPlane& plane);

/// Returns where a point of a curve in the plane is.
sim::Vec3 place_in(const CuttingPlane& plane, const sim::Vec2& point);

/// Returns the length along the curve, in m; of a closed one all around.
double length_m(const SectionCurve& curve);

/// Returns the corners of the points' convex hull, anticlockwise. Requires a point.
std::vector<sim::Vec2> convex_hull(std::vector<sim::Vec2> points_m);

/// Returns whether the point is within the hull, or on it.
bool is_in_hull(const std::vector<sim::Vec2>& hull, const sim::Vec2& point);

/// Returns the length of a tight tape around the points, in m: of their convex hull.
double tight_tape_m(std::vector<sim::Vec2> points_m);

/// Returns whether the closed curve goes around the plane's point.
bool is_around_point(const SectionCurve& curve);

/// The end of a sleeve or of a leg.
struct LimbOpening {
  sim::Vec3 middle_m;
  double length_m = 0.0;  ///< around
};

/// Says where on a body a garment belongs, by its landmarks or else by the openings of its largest part.
struct GarmentMarks {
  /// The border that goes around the neck, or around the waist where nothing else is open above the middle
  /// or below it in the middle, as of skirts and trousers. Empty: there is none.
  std::optional<sim::Extent> top;
  bool is_worn_at_waist = false;
  bool is_open_in_front = false;       ///< from the neck to the hem, as a jacket; it goes around no trunk
  double top_height_m = 0.0;           ///< mean of its vertices
  double neck_base_m = 0.0;            ///< height of its upper end, or where a hood or a stand collar ends
  double top_m = 0.0;                  ///< around; 0: it is no opening
  std::optional<double> hem_height_m;  ///< mean of its vertices; empty: it has none
  double hem_m = 0.0;                  ///< around
  std::vector<LimbOpening> cuffs;      ///< of two sleeves, or of two armholes; or none
  std::vector<LimbOpening> legs;       ///< of two legs, or none
  /// Level and of length 1: where its front is; of a front that is not known either way.
  sim::Vec3 front = {0.0, 0.0, 1.0};
  bool is_front_known = false;
};

/// Finds them where the garment is at these positions, in m. A neckline is lower in front.
GarmentMarks marks_of(const sim::Garment& garment, std::span<const sim::Vec3> positions_m, const Landmarks& landmarks);

/// Returns the opening whose middle is nearest. Requires one.
const LimbOpening& nearest_of(const std::vector<LimbOpening>& openings, const sim::Vec3& place_m);

/// The trunk of a garment, without its sleeves.
struct GarmentTube {
  double lowest_m = 0.0;              ///< height of the lowest level that goes all around
  double highest_m = 0.0;             ///< of the highest, which of a shirt is under its armholes
  std::optional<double> fork_m = {};  ///< of the highest that goes around two legs
};

/// Returns the tube; empty if no level goes all around, as of a jacket that is open in front.
std::optional<GarmentTube> tube_of(const Surface& garment);

/// Returns the length of the cloth around the trunk at this height, in m, of two legs that of a tight tape around
/// both; empty where it does not go all around.
std::optional<double> girth_at(const Surface& garment, double height_m);

/// Returns the length of the cloth around one leg at this height, in m; empty where there are no two.
std::optional<double> leg_at(const Surface& garment, double height_m);

}  // namespace taut::app
