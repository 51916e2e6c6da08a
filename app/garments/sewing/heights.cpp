#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/garments/dressing/tuning.hpp"
#include "app/garments/sewing/placing.hpp"
#include "app/garments/sewing/tuning.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec3;
using namespace sewing;

/// Marks the shoulder seams: seams between front and back that are nearly level, and near the highest of these. Those
/// that begin above `neck_m` and within `half_width_m` of the middle may be long, as in a poncho.
void mark_shoulder_seams(const SewingPattern& pattern, double neck_m, double half_width_m, CutPieces& pieces) {
  const std::vector<sim::Extent> boxes = panel_boxes(pieces);
  std::vector<std::pair<double, std::size_t>> seams;  ///< height in m, stitch
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const auto& [first, second] = pattern.stitches[s];
    const auto [from, to] = pattern.placed_ends_m(first);
    const double top_m = std::max(from.y, to.y);
    const bool is_between = boxes[first.panel].middle().z * boxes[second.panel].middle().z < 0.0;
    const bool is_level = std::abs(to.x - from.x) > shoulder_slope * std::abs(to.y - from.y);
    const bool is_near_neck = top_m > neck_m && std::min(std::abs(from.x), std::abs(to.x)) < half_width_m;
    const bool is_short = polyline_length(pattern.line_of(first)) < max_shoulder_m;
    if (is_between && is_level && from.x * to.x >= 0.0 && (is_short || is_near_neck)) seams.emplace_back(top_m, s);
  }
  for (const auto& [height_m, s] : seams) {
    if (height_m >= std::ranges::max(seams).first - near_top_m) pieces.first_seams.push_back(s);
  }
}

/// Returns how far shoulder seams have to rise to lie above the shoulders of the thin body, which is narrower than they
/// are. It is infinite if none of them is above it: they are level seams beside it.
double rise_over(const SewingPattern& pattern, const CutPieces& pieces, double x_m, const Wearer& wearer,
                 double half_width_m) {
  constexpr std::size_t steps = 8;
  double rise_m = -std::numeric_limits<double>::infinity();
  if (pieces.first_seams.empty()) return rise_m;
  const std::vector<Vec3> thin_m = placed_m(wearer.places, compute_thin_shape(*wearer.rig, wearer.pose));
  for (const std::size_t s : pieces.first_seams) {
    const PanelEdge& side = pattern.stitches[s].first;
    for (const sim::Vec2& point : evenly_along(pattern.line_of(side), steps)) {
      const Vec3 seam = pattern.panels[side.panel].placed_m(point);
      for (const Vec3& p : thin_m) {
        const double x = std::abs(p.x - x_m), off_m = std::abs(p.x - seam.x);
        const bool is_below = std::abs(p.x - x_m - seam.x) < beside_seam_m && x < half_width_m && off_m < x;
        rise_m = is_below ? std::max(rise_m, p.y - seam.y) : rise_m;
      }
    }
  }
  return rise_m;
}

/// Returns the length of unsewn edges near the top.
double upper_border_m(const SewingPattern& pattern, double top_m) {
  double sum_m = 0.0;
  for (const PanelEdge& edge : pattern.unsewn_edges()) {
    const auto [from, to] = pattern.placed_ends_m(edge);
    sum_m += 0.5 * (from.y + to.y) > top_m - near_top_m ? polyline_length(pattern.line_of(edge)) : 0.0;
  }
  return sum_m;
}

/// Returns the height of the nearest level that the border goes around; nothing if there is none. Levels of the chest
/// count for what is meant to be that high, such as a dress without straps.
std::optional<double> level_for(const BodyMeasures& measures, double border_m, double height_m) {
  std::optional<double> best_m;
  double min_distance_m = std::numeric_limits<double>::infinity();
  const double fork_m = measures.levels[measures.fork].height_m;
  const double waist_limit_m =
      fork_m + dressing::max_waist_height_fraction * (measures.levels.back().height_m - fork_m);
  for (const LevelTape& level : measures.levels) {
    const double off_m = std::abs(level.height_m - height_m);
    const bool is_of_trunk = level.height_m >= fork_m && level.height_m < std::max(waist_limit_m, height_m);
    if (is_of_trunk && level.girth_m <= border_m && off_m < min_distance_m) {
      min_distance_m = off_m;
      best_m = level.height_m;
    }
  }
  return best_m;
}

}  // namespace

Vec3 compute_shift(const SewingPattern& pattern, const Wearer& wearer, CutPieces& pieces,
                   std::vector<std::string>& said) {
  const sim::Extent box = sim::compute_extent(pieces.placed_m);
  const BodyMeasures& measures = wearer.measures;
  if (!measures.neck_m || measures.levels.empty()) {
    throw InputError("found a body without a neck and arms to be told, expected someone who stands upright");
  }
  if (!pattern.joint.empty()) {
    const auto joint = wearer.joints.find(pattern.joint);
    if (joint != wearer.joints.end()) return joint->second;
    throw InputError("properties.joint: found '{}', expected a joint of the body: {}", pattern.joint,
                     join(collect<std::string>(wearer.joints, &JointPlaces::value_type::first)));
  }
  const double feet_m = sim::compute_extent(wearer.full_m).lower.y, top_m = box.upper.y;
  Vec3 shift = *measures.neck_m - Vec3(0.0, measures.neck_m->y, 0.0);
  shift.y = box.middle().y > min_middle_m ? feet_m : measures.neck_m->y - neck_over_chest_m;
  const std::vector<ArmJoints> arms = find_arms(wearer.joints);
  const double half_width_m = arms.empty() ? 0.0 : std::abs(arms[0].shoulder_m.x - shift.x);
  mark_shoulder_seams(pattern, 0.5 * (measures.waist_m->y + measures.neck_m->y) - shift.y, half_width_m, pieces);
  const double rise_m = rise_over(pattern, pieces, shift.x, wearer, half_width_m);
  if (std::isfinite(rise_m)) {
    shift.y = above_shoulders_m + rise_m;
  } else {
    pieces.first_seams.clear();
    shift.y =
        level_for(measures, upper_border_m(pattern, top_m), top_m + shift.y).value_or(measures.waist_m->y) - top_m;
  }
  said.push_back(fmt::format("its pieces are moved by {} m to be about the body", describe_point(shift)));
  return shift;
}

}  // namespace taut::app
