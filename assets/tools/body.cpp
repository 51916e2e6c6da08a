#include "body.hpp"

namespace taut::tailor {
namespace {

using sim::Capsule;
using sim::Vec3;

constexpr double friction = 0.0;  // the shirt slides to where it fits

/// Above, at and below the waist: half as deep as `radius_m`, and wider by `spread_m` on each side.
struct TrunkSection {
  double below_neck_point_m;
  double spread_m;
  double radius_m;
};

// The trunk is about 1.5 times as wide as deep. Girths, pi (2 radius) + 4 spread: chest 1.02, waist 0.86,
// seat 0.95 m.
constexpr TrunkSection trunk[] = {
    {0.12, 0.085, 0.060}, {0.22, 0.085, 0.100}, {0.30, 0.085, 0.108},
    {0.48, 0.060, 0.098}, {0.70, 0.060, 0.110}, {0.80, 0.060, 0.112},
};

void add(std::vector<sim::Collider>& body, const Vec3& start_m, const Vec3& end_m, double start_radius_m,
         double end_radius_m) {
  body.push_back({Capsule{start_m, end_m, start_radius_m, end_radius_m}, friction});
}

/// Three columns side by side stand for an elliptical trunk; the middle one is a little deeper.
void add_trunk(std::vector<sim::Collider>& body, double neck_point_height_m) {
  for (std::size_t i = 1; i < std::size(trunk); ++i) {
    const TrunkSection& top = trunk[i - 1];
    const TrunkSection& bottom = trunk[i];
    const double top_y = neck_point_height_m - top.below_neck_point_m;
    const double bottom_y = neck_point_height_m - bottom.below_neck_point_m;
    for (const double side : {-1.0, 0.0, 1.0}) {
      const double deeper_m = side == 0.0 ? 0.012 : 0.0;
      add(body, {side * top.spread_m, top_y, 0.0}, {side * bottom.spread_m, bottom_y, 0.0},
          top.radius_m + deeper_m, bottom.radius_m + deeper_m);
    }
  }
}

void add_shoulder_and_arm(std::vector<sim::Collider>& body, const Stance& stance, double side) {
  const double neck_y = stance.neck_point_height_m;
  const Vec3 by_neck = {side * 0.075, neck_y - 0.055, 0.0};
  const Vec3 joint = {side * 0.180, neck_y - 0.085, 0.0};
  const Vec3 arm = {side * stance.left_arm.x, stance.left_arm.y, stance.left_arm.z};
  add(body, by_neck, joint, 0.048, 0.055);
  add(body, joint, joint + 0.33 * arm, 0.055, 0.048);
}

}  // namespace

std::vector<sim::Collider> body_colliders(const Stance& stance) {
  std::vector<sim::Collider> body;
  add_trunk(body, stance.neck_point_height_m);
  add_shoulder_and_arm(body, stance, 1.0);
  add_shoulder_and_arm(body, stance, -1.0);
  const double neck_y = stance.neck_point_height_m;
  add(body, {0.0, neck_y - 0.10, 0.0}, {0.0, neck_y + 0.08, 0.01}, 0.062, 0.058);
  return body;
}

}  // namespace taut::tailor
