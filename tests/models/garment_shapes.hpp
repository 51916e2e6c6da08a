#pragma once

#include <functional>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::test {

/// Region of the drawing plane, seen from the front. The function returns whether the point (x, y), in m, is inside.
using Region = std::function<bool(double x_m, double y_m)>;

/// Cut of a garment: two sheets on a grid, sewn together where both end, except in the open region.
struct Cut {
  Region front;
  Region back;
  Region open;            ///< region in which the ends of sheets are not sewn
  double cell_m = 0.03;   ///< width of a square, which is cut into two triangles
  double depth_m = 0.12;  ///< distance from the middle of the front to the middle of the back
};

/// Makes the garment in metres with y up. It faces +z.
sim::Mesh sewn(const Cut& cut);

// Small garments, each like a kind of model that people have. All are upright, in metres, about 1 m high.

sim::Mesh shirt();
/// A shirt with a hole along one shoulder. The hole lies higher than the neckline.
sim::Mesh shirt_with_gap();
/// A jacket in one piece with the arms stretched out to the sides, open in front from the neck to the hem. The hem
/// reaches `hem_m` to each side.
sim::Mesh jacket(double hem_m = 0.24);
/// A garment without a neckline whose left sleeve is raised above the shoulders.
sim::Mesh raised_sleeve();
/// A dress with its neckline at this height and straps up to 0.9 m.
sim::Mesh strap_dress(double neckline_m = 0.57);
/// A garment with a hood up to `top_m`. The opening for the face begins at `face_from_m` and ends 6 cm below the top.
sim::Mesh hoodie(double top_m = 1.08, double face_from_m = 0.66, double shoulders_m = 0.5);
sim::Mesh trousers();
/// A tube that widens downwards.
sim::Mesh skirt();
/// A ring that lies flat, with waves of this height.
sim::Mesh circle_skirt(double wave_m = 0.004);
/// The neck of a bottle: an ellipse with these half axes and this offset from the middle of the top.
struct Neck {
  double half_x_m;
  double half_z_m;
  double off_x_m = 0.0;
  double off_z_m = 0.0;
};
/// A tube 0.4 m wide, open below and closed at its top around a neck.
sim::Mesh bottle(double height_m, const Neck& neck);
/// A sheet that lies over shoulders, open in front.
sim::Mesh cape();
/// A tube that is closed at its top, with a lining that ends at this fraction of its height.
sim::Mesh lined_bell(double lining_from);
/// Separate panels side by side around a tube. Gaps of `gap_m` lie between their borders.
sim::Mesh panels(int count, double gap_m);

/// The mesh with a second wall at this distance inside it, joined at the borders. The result has no border.
sim::Mesh thick(const sim::Mesh& mesh, double thickness_m = 0.004);
/// A bodice with armholes above a skirt that widens to this radius.
sim::Mesh dress_with_wide_skirt(double hem_m = 0.6);
/// A tube with a seam that was left open by this much. Its one border runs along both sides of the seam.
sim::Mesh split_tube(double gap_m);

/// Two meshes as one, not joined.
sim::Mesh both(const sim::Mesh& a, const sim::Mesh& b);
sim::Mesh translate(sim::Mesh mesh, const sim::Vec3& by_m);
/// A disc of this radius around this point, which faces +z.
sim::Mesh button(const sim::Vec3& at_m, double radius_m);
/// The mesh with all triangles facing the other side.
sim::Mesh inside_out(sim::Mesh mesh);
/// A tube of 0.5 m whose upper end is turned down over its outside to this height.
sim::Mesh turned_down(double until_m);
/// The same garment in a file with z up.
sim::Mesh with_z_up(sim::Mesh mesh);
/// The same garment pressed flat and laid on its back, its top towards -z, in a file with y up.
sim::Mesh laid_flat(sim::Mesh mesh);

}  // namespace taut::test
