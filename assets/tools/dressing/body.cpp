#include "tailor/dressing/body.hpp"

namespace taut::tailor {
namespace {

using sim::Capsule;
using sim::Vec3;

constexpr double friction = 0.0;  // the shirt slides to where it fits

/// Three columns side by side stand for an elliptical trunk. Their cross-section at one height:
struct TrunkSection {
  double below_neck_point_m;
  double spread_m;  ///< of the outer columns from the middle
  double outer_radius_m;
  double middle_radius_m;
};

// About twice as wide as deep. Girths from chest to hem: 1.10, 1.01, 1.01 m, where the shirt has 1.18, 1.08
// and 1.04 m: enough ease to slide, too little for the cloth to stand off in a ridge.
constexpr TrunkSection trunk[] = {
    {0.12, 0.100, 0.050, 0.075},
    {0.30, 0.140, 0.085, 0.110},
    {0.48, 0.125, 0.080, 0.105},
    {0.80, 0.125, 0.080, 0.105},
};

void add(std::vector<sim::Body>& body, const Vec3& start_m, const Vec3& end_m, double start_radius_m,
         double end_radius_m) {
  body.push_back({.shape = Capsule{start_m, end_m, start_radius_m, end_radius_m}, .friction = friction});
}

void add_trunk(std::vector<sim::Body>& body, const Stance& stance) {
  for (std::size_t i = 1; i < std::size(trunk); ++i) {
    const TrunkSection& top = trunk[i - 1];
    const TrunkSection& bottom = trunk[i];
    const double t = stance.trunk;
    const double top_y = stance.neck_point_height_m - t * top.below_neck_point_m;
    const double bottom_y = stance.neck_point_height_m - t * bottom.below_neck_point_m;
    for (const double side : {-1.0, 1.0}) {
      add(body, {side * t * top.spread_m, top_y, 0.0}, {side * t * bottom.spread_m, bottom_y, 0.0},
          t * top.outer_radius_m, t * bottom.outer_radius_m);
    }
    add(body, {0.0, top_y, 0.0}, {0.0, bottom_y, 0.0}, t * top.middle_radius_m, t * bottom.middle_radius_m);
  }
}

void add_shoulder_and_arm(std::vector<sim::Body>& body, const Stance& stance, double side) {
  const double neck_y = stance.neck_point_height_m;
  const double t = stance.trunk;
  const double s = stance.sleeve;
  const Vec3 by_neck = {side * t * 0.075, neck_y - t * 0.055, 0.0};
  const Vec3 joint = {side * t * 0.180, neck_y - t * 0.085, 0.0};
  const Vec3 arm = {side * stance.left_arm.x, stance.left_arm.y, stance.left_arm.z};
  add(body, by_neck, joint, s * 0.048, s * 0.055);
  add(body, joint, joint + 0.33 * arm, s * 0.055, s * 0.048);
}

}  // namespace

std::vector<sim::Body> body_parts(const Stance& stance) {
  std::vector<sim::Body> body;
  add_trunk(body, stance);
  add_shoulder_and_arm(body, stance, 1.0);
  add_shoulder_and_arm(body, stance, -1.0);
  const double neck_y = stance.neck_point_height_m;
  // Collar bones and shoulder blades: without them the neckline hangs in points.
  const double t = stance.trunk;
  const auto at = [&](double x, double y, double z) { return Vec3(t * x, neck_y + t * y, t * z); };
  add(body, at(-0.065, -0.115, 0.030), at(0.065, -0.115, 0.030), t * 0.045, t * 0.045);
  add(body, at(-0.080, -0.140, -0.040), at(0.080, -0.140, -0.040), t * 0.050, t * 0.050);
  add(body, at(0.0, -0.10, 0.0), at(0.0, 0.08, 0.01), t * 0.062, t * 0.058);
  return body;
}

}  // namespace taut::tailor
