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

double panel_depth(const PatternPanel& panel) {
  sim::Extent extent;
  for (const auto& line : panel.edges_m) extent.add(panel.placed_m(line.front()));
  return extent.middle().z;
}

/// Region in which long shoulder seams begin: above a height of the pattern, and near its middle.
struct NearNeck {
  double height_m, half_width_m;

  bool contains(const Vec3& from, const Vec3& to) const {
    return std::max(from.y, to.y) > height_m && std::min(std::abs(from.x), std::abs(to.x)) < half_width_m;
  }
};

/// Marks the shoulder seams: seams between front and back that are nearly level, and near the highest of these. Those
/// that begin near the neck may be long, as in a poncho. Returns points along them.
std::vector<Vec3> find_shoulder_seams(const SewingPattern& pattern, const NearNeck& near_neck, CutPieces& pieces) {
  constexpr std::size_t steps = 8;
  const auto ends_of = [&](std::size_t s) {
    const PanelEdge& side = pattern.stitches[s].first;
    const auto& line = pattern.line_of(side);
    const PatternPanel& panel = pattern.panels[side.panel];
    return std::pair(panel.placed_m(line.front()), panel.placed_m(line.back()));
  };
  double max_height_m = -std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const auto& [first, second] = pattern.stitches[s];
    const auto [from, to] = ends_of(s);
    const bool is_beside = from.x * to.x >= 0.0;
    const bool is_level = std::abs(to.x - from.x) > shoulder_slope * std::abs(to.y - from.y);
    if (panel_depth(pattern.panels[first.panel]) * panel_depth(pattern.panels[second.panel]) < 0.0 && is_beside &&
        is_level && (polyline_length(pattern.line_of(first)) < max_shoulder_m || near_neck.contains(from, to))) {
      pieces.first_seams.push_back(s);
      max_height_m = std::max({max_height_m, from.y, to.y});
    }
  }
  std::erase_if(pieces.first_seams, [&](std::size_t s) {
    const auto [from, to] = ends_of(s);
    return std::max(from.y, to.y) < max_height_m - near_top_m;
  });
  std::vector<Vec3> points_m;
  for (const std::size_t s : pieces.first_seams) {
    const PanelEdge& side = pattern.stitches[s].first;
    for (const sim::Vec2& point : evenly_along(pattern.line_of(side), steps)) {
      points_m.push_back(pattern.panels[side.panel].placed_m(point));
    }
  }
  return points_m;
}

/// Returns how far shoulder seams have to rise to lie above the shoulders of the thin body, which is narrower than they
/// are. Empty if none of them is above it: they are level seams beside it.
std::optional<double> rise_over(const std::vector<Vec3>& seams_m, double x_m, const std::vector<Vec3>& thin_m,
                                double half_width_m) {
  double rise_m = -std::numeric_limits<double>::infinity();
  for (const Vec3& seam : seams_m) {
    double top_m = -std::numeric_limits<double>::infinity();
    for (const Vec3& p : thin_m) {
      const double x = p.x - x_m;
      if (std::abs(x - seam.x) < beside_seam_m && std::abs(x) < half_width_m && std::abs(p.x - seam.x) < std::abs(x)) {
        top_m = std::max(top_m, p.y);
      }
    }
    rise_m = std::max(rise_m, top_m - seam.y);
  }
  return std::isfinite(rise_m) ? std::optional(rise_m) : std::nullopt;
}

/// Returns the length of unsewn edges near the top.
double upper_border_m(const SewingPattern& pattern, double top_m) {
  double sum_m = 0.0;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const std::vector<char> stitched = pattern.is_stitched(p);
    const PatternPanel& panel = pattern.panels[p];
    for (std::size_t e = 0; e < stitched.size(); ++e) {
      const auto& line = panel.edges_m[e];
      const double height_m = 0.5 * (panel.placed_m(line.front()).y + panel.placed_m(line.back()).y);
      sum_m += stitched[e] == 0 && height_m > top_m - near_top_m ? polyline_length(line) : 0.0;
    }
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
  const bool stands_at_feet = box.lower.y > floor_at_m && top_m > min_top_m;
  Vec3 shift = *measures.neck_m - Vec3(0.0, measures.neck_m->y, 0.0);
  shift.y = stands_at_feet ? feet_m : measures.neck_m->y - neck_over_chest_m;
  const std::vector<ArmJoints> arms = find_arms(wearer.joints);
  const double half_width_m = arms.empty() ? 0.0 : std::abs(arms[0].shoulder_m.x - shift.x);
  const double waist_m = measures.waist_m ? measures.waist_m->y : measures.neck_m->y;
  const NearNeck near_neck = {0.5 * (waist_m + measures.neck_m->y) - shift.y, half_width_m};
  const std::vector<Vec3> shoulders_m = find_shoulder_seams(pattern, near_neck, pieces);
  std::optional<double> rise_m;
  if (!shoulders_m.empty() && !arms.empty()) {
    const std::vector<Vec3> thin_m = placed_m(wearer.places, compute_thin_shape(*wearer.rig, wearer.pose));
    rise_m = rise_over(shoulders_m, shift.x, thin_m, half_width_m);
    if (!rise_m) pieces.first_seams.clear();
  }
  if (rise_m) {
    shift.y = above_shoulders_m + *rise_m;
  } else {
    const double usual_m = measures.waist_m ? measures.waist_m->y : top_m + shift.y;
    shift.y = level_for(measures, upper_border_m(pattern, top_m), top_m + shift.y).value_or(usual_m) - top_m;
  }
  if (glm::length(shift) > hardly_moved_m) {
    said.push_back(fmt::format("its pieces are moved by {} m to be about the body", describe_point(shift)));
  }
  return shift;
}

/// Lifts panels that hang from a level seam, such as a skirt from the waist of a dress. They rise to where the body is
/// no wider than the seam, if it is wider at the seam. Patterns place skirts below bodices that are longer than the
/// body.
void lift_to_waist(const SewingPattern& pattern, const BodyMeasures& measures, double shoulder_m, CutPieces& pieces) {
  const std::vector<sim::Extent> boxes = panel_boxes(pieces);
  std::set<std::size_t> upper, lower;
  double border_m = 0.0, height_m = 0.0;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    auto [above, below] = pattern.stitches[s];
    if (boxes[above.panel].middle().y < boxes[below.panel].middle().y) std::swap(above, below);
    const Seam& seam = pieces.seams[s];
    const bool is_swapped = pieces.panel_of[seam[0].first] != above.panel;
    const auto at = [&](std::size_t k) { return pieces.placed_m[is_swapped ? seam[k].second : seam[k].first]; };
    const Vec3 way = at(seam.size() - 1) - at(0);
    if (boxes[above.panel].middle().y > boxes[below.panel].middle().y + min_depth_under_m &&
        std::abs(way.y) < level_seam * glm::length(way) && at(0).y < shoulder_m - below_top_m) {
      upper.insert(above.panel);
      lower.insert(below.panel);
      border_m += std::min(polyline_length(pattern.line_of(above)), polyline_length(pattern.line_of(below)));
      height_m = std::max(height_m, at(0).y);
    }
  }
  lower = pattern.sewn_with(std::move(lower), [&](std::size_t p) { return !upper.contains(p); });
  if (lower.empty() || std::ranges::any_of(upper, [&](std::size_t p) { return lower.contains(p); })) return;
  const double lift_m = level_for(measures, border_m, height_m).value_or(height_m) - height_m;
  for (std::size_t v = 0; v < pieces.placed_m.size(); ++v) {
    pieces.placed_m[v].y += lower.contains(pieces.panel_of[v]) ? std::max(lift_m, 0.0) : 0.0;
  }
}

}  // namespace

Vec3 move_to_height(const SewingPattern& pattern, const Wearer& wearer, CutPieces& pieces,
                    std::vector<std::string>& said) {
  const Vec3 shift = compute_shift(pattern, wearer, pieces, said);
  for (Vec3& position : pieces.placed_m) position += shift;
  if (!pieces.first_seams.empty()) {
    lift_to_waist(pattern, wearer.measures, sim::compute_extent(pieces.placed_m).upper.y, pieces);
  }
  return shift;
}

}  // namespace taut::app
