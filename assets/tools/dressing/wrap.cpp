#include "tailor/dressing/wrap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace taut::tailor {
namespace {

constexpr int arc_steps = 64;  // of a quarter ellipse

/// A point of the quarter of the unit circle from (0, 1) to (1, 0). Rational, because sine and cosine differ
/// in the last bit from one C library and processor to the next.
Vec2 on_unit_quarter(int step) {
  const double t = static_cast<double>(step) / arc_steps;
  return Vec2(2.0 * t, 1.0 - t * t) / (1.0 + t * t);
}

/// The quarter of an ellipse from its front (0, depth) to its side (width, 0), walked by arc length.
struct QuarterEllipse {
  double width_m;
  double depth_m;

  Vec2 point(int step) const { return Vec2(width_m, depth_m) * on_unit_quarter(step); }

  double length() const {
    double length_m = 0.0;
    for (int i = 1; i <= arc_steps; ++i) {
      length_m += glm::length(point(i) - point(i - 1));
    }
    return length_m;
  }

  /// Beyond the quarter, straight on.
  Vec2 at(double arc_m) const {
    for (int i = 1; i < arc_steps; ++i) {
      const double step_m = glm::length(point(i) - point(i - 1));
      if (arc_m <= step_m) {
        return point(i - 1) + (point(i) - point(i - 1)) * (arc_m / step_m);
      }
      arc_m -= step_m;
    }
    const Vec2 last = point(arc_steps) - point(arc_steps - 1);
    return point(arc_steps - 1) + last * (arc_m / glm::length(last));
  }
};

/// As wide as it takes for a quarter to be `length_m` long.
QuarterEllipse ellipse_of_length(double depth_m, double length_m) {
  double low = 0.0;
  double high = length_m;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (QuarterEllipse{middle, depth_m}.length() < length_m ? low : high) = middle;
  }
  return {high, depth_m};
}

/// From the top of the shoulder down: how far below it and how far in front of it the cloth lies.
constexpr std::array<Vec2, 9> profile_m = {{{0.000, 0.000},
                                            {0.004, 0.022},
                                            {0.015, 0.042},
                                            {0.035, 0.060},
                                            {0.080, 0.080},
                                            {0.160, 0.102},
                                            {0.260, 0.120},
                                            {0.450, 0.120},
                                            {0.900, 0.112}}};

/// Half the width of the body pieces at a height of the pattern, 0 at the neck point and negative below:
/// wide at the chest, narrower at the hem.
double half_width(const Panel& body, double flat_y, const Stance& stance) {
  const double chest_y = -0.279 * stance.trunk;
  if (flat_y >= chest_y) {
    flat_y = chest_y;
  }
  // The outline runs up the side with positive x first; past the armpit it turns inwards.
  double best = 0.0;
  double nearest = 1.0;
  for (std::size_t i = 0; i < body.outline_count; ++i) {
    const Vec2& p = body.flat_m[i];
    const double off = std::abs(p.y - flat_y);
    if (p.x > 0.25 * stance.trunk && off < nearest) {
      nearest = off;
      best = p.x;
    }
  }
  return best;
}

Vec3 wrap_on_trunk(const Panel& panel, const Vec2& flat, const Stance& stance) {
  const double across_m = std::abs(flat.x);
  // The shoulder seam's line through the shirt, level with the neck point at 83 mm from the centre. It begins
  // 128 mm from the centre; carried on to the centre it would put a crease down the middle.
  const double ridge_y =
      -stance.shoulder_slope * (std::max(across_m, stance.trunk * 0.128) - stance.trunk * 0.0833);
  const double down = std::max(0.0, ridge_y - flat.y) / (stance.trunk * length_of(profile_m));
  const Vec2 fall = stance.trunk * point_at_fraction(profile_m, down);
  const Vec2 around = ellipse_of_length(fall.y, half_width(panel, flat.y, stance)).at(across_m);
  const bool is_front = panel.kind == PieceKind::front;
  const bool is_left = (flat.x > 0.0) == is_front;
  return {is_left ? around.x : -around.x, stance.neck_point_height_m + ridge_y - fall.x,
          is_front ? around.y : -around.y};
}

/// Around a circle as long as the sleeve is wide, its top above the shoulder and its seam below the arm.
Vec3 wrap_on_arm(const Panel& panel, const Vec2& flat, const Stance& stance) {
  const double cap_height_m = stance.sleeve * 0.1618;
  const double quarter_m = stance.sleeve * 0.43096 / 4.0;
  const Vec3 shoulder = {stance.trunk * 0.226, stance.neck_point_height_m - stance.trunk * 0.0344, 0.0};
  const Vec3 up = {-stance.left_arm.y, stance.left_arm.x, 0.0};
  const double radius_m = ellipse_of_length(stance.sleeve * 0.0686, quarter_m).width_m;
  const QuarterEllipse circle = {radius_m, radius_m};
  const double arc_m = std::abs(flat.x);
  // Past the side the quarter is walked back from the bottom.
  const bool is_below = arc_m > quarter_m;
  const Vec2 round = circle.at(is_below ? 2.0 * quarter_m - arc_m : arc_m);
  const Vec3 centre = shoulder - radius_m * up + (cap_height_m - flat.y) * stance.left_arm;
  const bool is_left = panel.kind == PieceKind::left_sleeve;
  const bool is_front = (flat.x > 0.0) != is_left;
  const Vec3 on_left =
      centre + (is_below ? -round.y : round.y) * up + Vec3(0.0, 0.0, is_front ? round.x : -round.x);
  return {is_left ? on_left.x : -on_left.x, on_left.y, on_left.z};
}

}  // namespace

std::vector<Vec3> wrap_shirt(const Shirt& shirt, const Stance& stance) {
  std::vector<Vec3> positions(shirt.vertex_count, Vec3(0.0));
  std::vector<int> shares(shirt.vertex_count, 0);
  for (const Panel& panel : shirt.panels) {
    const bool is_body = panel.kind == PieceKind::front || panel.kind == PieceKind::back;
    for (std::size_t p = 0; p < panel.flat_m.size(); ++p) {
      const Vec2& flat = panel.flat_m[p];
      positions[panel.vertices[p]] +=
          is_body ? wrap_on_trunk(panel, flat, stance) : wrap_on_arm(panel, flat, stance);
      ++shares[panel.vertices[p]];
    }
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    positions[v] /= static_cast<double>(shares[v]);
  }
  return positions;
}

}  // namespace taut::tailor
