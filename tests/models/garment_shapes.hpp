#pragma once

#include <functional>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::test {

/// A region of the drawing plane, seen from the front: whether the point (x, y), in m, is in it.
using Region = std::function<bool(double x_m, double y_m)>;

/// A garment as it is cut: two sheets on a grid, sewn where both end, but not where it stays open.
struct Cut {
  Region front;
  Region back;
  Region open;            ///< where sheets that end at one place are not sewn
  double cell_m = 0.03;   ///< width of a square, which is cut into two triangles
  double depth_m = 0.12;  ///< from the middle of the front to that of the back
};

/// Makes the garment. It is in metres with y up, and faces +z.
sim::Mesh sewn(const Cut& cut);

// Small garments, each after a kind of model that people have. All are upright, in metres, about 1 m high.

sim::Mesh shirt();
/// With a hole along one shoulder, which lies higher than the neckline.
sim::Mesh shirt_with_gap();
/// In one piece with the arms stretched out to the sides, open in front from the neck to the hem, which
/// reaches so far to each side.
sim::Mesh jacket(double hem_m = 0.24);
/// Its left sleeve is raised above the shoulders; it has no neckline.
sim::Mesh raised_sleeve();
/// Its neckline is at this height, its straps reach up to 0.9 m.
sim::Mesh strap_dress(double neckline_m = 0.57);
/// Its hood ends at `top_m`; the opening for the face begins at `face_from_m` and ends 6 cm below the top.
sim::Mesh hoodie(double top_m = 1.08, double face_from_m = 0.66, double shoulders_m = 0.5);
sim::Mesh trousers();
/// A tube that widens downwards.
sim::Mesh skirt();
/// A ring that lies flat but for waves of this height.
sim::Mesh circle_skirt(double wave_m = 0.004);
/// The neck of a bottle: an ellipse with these half axes, off the middle of the top.
struct Neck {
  double half_x_m;
  double half_z_m;
  double off_x_m = 0.0;
  double off_z_m = 0.0;
};
/// A tube 0.4 m wide that is closed at its top but for a neck, and open below.
sim::Mesh bottle(double height_m, const Neck& neck);
/// A sheet that lies over shoulders, open in front.
sim::Mesh cape();
/// Closed at its top, with a lining that ends at this share of its height.
sim::Mesh lined_bell(double lining_from);
/// Separate panels side by side around a tube, whose borders lie this far apart.
sim::Mesh panels(int count, double gap_m);

/// Cut along its own middle plane into two sheets, which hold a wall of this thickness: it has no border.
sim::Mesh thick(const sim::Mesh& mesh, double thickness_m = 0.004);
/// A bodice with armholes above a skirt that widens to this radius.
sim::Mesh dress_with_wide_skirt(double hem_m = 0.6);
/// A tube whose border runs down a seam that was left open by this much.
sim::Mesh split_tube(double gap_m);

/// Both as one mesh, not joined.
sim::Mesh both(const sim::Mesh& a, const sim::Mesh& b);
sim::Mesh moved(sim::Mesh mesh, const sim::Vec3& by_m);
/// A disc of this radius that lies in front of this place.
sim::Mesh button(const sim::Vec3& at_m, double radius_m);
/// Every triangle faces the other side.
sim::Mesh inside_out(sim::Mesh mesh);
/// A tube of 0.5 m whose upper end is turned down over its outside to this height.
sim::Mesh turned_down(double until_m);
/// The same garment in a file with z up.
sim::Mesh with_z_up(sim::Mesh mesh);
/// The same garment pressed flat and laid on its back, its top towards -z, in a file with y up.
sim::Mesh laid_flat(sim::Mesh mesh);

}  // namespace taut::test
