#pragma once

#include "app/models/garment_loading.hpp"

namespace taut::app {

/// Plane that cuts a surface.
struct CuttingPlane {
  sim::Vec3 point_m = {0.0, 0.0, 0.0};
  sim::Vec3 normal = {0.0, 1.0, 0.0};  ///< unit vector
};

/// A curve that a plane cuts out of a surface.
struct SectionCurve {
  /// Points along the curve in the plane, in m from the plane's point. The axes of a level plane are x, and z
  /// backwards.
  std::vector<sim::Vec2> points_m;
  bool is_closed = false;
};

/// Returns the curves that the plane cuts out of the surface. A curve ends at an edge of more than two triangles.
std::vector<SectionCurve> cut_section(const sim::Surface& surface, const CuttingPlane& plane);

/// Returns the position in space of a point of a curve in the plane.
sim::Vec3 place_in(const CuttingPlane& plane, const sim::Vec2& point);

/// Returns the length of the curve, in m, all around if it is closed.
double length_m(const SectionCurve& curve);

/// Returns the corners of the points' convex hull, anticlockwise. Requires a point.
std::vector<sim::Vec2> convex_hull(std::vector<sim::Vec2> points_m);

/// Returns whether the point is within the hull, or on it.
bool is_in_hull(const std::vector<sim::Vec2>& hull, const sim::Vec2& point);

/// Returns the length of a tight tape around the points, in m: the circumference of their convex hull.
double tight_tape_m(std::vector<sim::Vec2> points_m);

/// Returns whether the closed curve goes around the plane's point.
bool is_around_point(const SectionCurve& curve);

/// End of a sleeve or of a leg.
struct LimbOpening {
  sim::Vec3 middle_m;
  double length_m = 0.0;  ///< length around it
};

/// Marks that place a garment on a body, from its landmarks or else from the openings of its largest part.
struct GarmentMarks {
  /// Border around the neck; or around the waist if nothing else is open above the middle or below it in the middle, as
  /// in skirts and trousers. Empty if there is none.
  std::optional<sim::Extent> top;
  bool is_worn_at_waist = false;
  bool is_open_in_front = false;       ///< true for a jacket that is open from the neck to the hem
  double top_height_m = 0.0;           ///< mean height of its vertices
  double neck_base_m = 0.0;            ///< height of its upper end, or of the end of a hood or a stand collar
  double top_m = 0.0;                  ///< length around it; 0 if it is no opening
  std::optional<double> hem_height_m;  ///< mean height of the hem's vertices; empty if there is no hem
  double hem_m = 0.0;                  ///< length around the hem
  std::vector<LimbOpening> cuffs;      ///< openings of two sleeves, or of two armholes; or none
  std::vector<LimbOpening> legs;       ///< openings of two legs, or none
  /// Level unit vector to the front; either way if the front is not known.
  sim::Vec3 front = {0.0, 0.0, 1.0};
  bool is_front_known = false;
};

/// Finds the marks of a garment at these positions, in m. A neckline is lower in front.
GarmentMarks find_garment_marks(const sim::Garment& garment, std::span<const sim::Vec3> positions_m,
                                const Landmarks& landmarks);

/// Returns the opening whose middle is nearest. Requires at least one opening.
const LimbOpening& find_nearest_opening(const std::vector<LimbOpening>& openings, const sim::Vec3& place_m);

/// The trunk of a garment, without its sleeves.
struct GarmentTube {
  double min_height_m = 0.0;          ///< height of the lowest level that goes all around
  double max_height_m = 0.0;          ///< height of the highest such level; a shirt's is under its armholes
  std::optional<double> fork_m = {};  ///< height of the highest level that goes around two legs
};

/// Returns the tube; empty if no level goes all around, as in a jacket that is open in front.
std::optional<GarmentTube> find_tube(const sim::Surface& garment);

/// Returns the length of the cloth around the trunk at this height, in m, or of a tight tape around two legs. Empty if
/// it does not go all around.
std::optional<double> girth_at(const sim::Surface& garment, double height_m);

/// Returns the length of the cloth around one leg at this height, in m; empty if there are not two legs.
std::optional<double> leg_at(const sim::Surface& garment, double height_m);

}  // namespace taut::app
