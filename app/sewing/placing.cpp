#include "app/sewing/placing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "app/base/errors.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/bodies/dressing.hpp"
#include "app/bodies/wearing.hpp"
#include "app/models/scene_crossings.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec3;

// Patterns whose lowest point is no lower and whose highest is no lower than these have the feet of their body at the
// origin, others its chest.
constexpr double floor_at_m = -0.05;
constexpr double lowest_top_m = 0.5;
/// Where the side of the neck of a body is above its chest, if the origin is there.
constexpr double neck_over_chest_m = 0.29;
constexpr double above_shoulders_m = 0.06;   ///< of shoulder seams over the thin body
constexpr double beside_seam_m = 0.015;
constexpr double shoulder_slope = 0.9;       ///< a shoulder seam goes further sideways than this times up
constexpr double longest_shoulder_m = 0.3;
constexpr double near_top_m = 0.2;
constexpr double beside_shoulder = 1.1;  ///< times as far out as its joint: what is sewn to nothing there is a cuff
constexpr double beside_trunk = 0.6;     ///< times as far out: a panel of a sleeve is no further in
constexpr double below_shoulder_m = 0.2;  ///< the top of a panel of a sleeve, at most
constexpr double outermost = 0.85;       ///< of the furthest of them
constexpr double arms_down = 0.2;        ///< of their length, where there are no sleeves
constexpr double highest_waist = 0.8;  ///< of the way from the fork to the arms
constexpr double least_under_m = 0.1;  ///< of the middle of a skirt from that of its bodice
constexpr double level_seam = 0.3;
constexpr double gathered = 1.05;       ///< times as long as what it is sewn to
constexpr double near_hem_m = 0.05;
constexpr double beyond_middle_m = 0.08;  ///< of a panel of one leg
constexpr double step_m = 0.01;
constexpr double clear_m = 0.03;     ///< of pieces from what they are drawn to
constexpr double same_way = 0.8;      ///< cosine
constexpr double least_level = 0.1;  ///< part of a normal, or the piece lies flat
constexpr int most_pushes = 80;

std::vector<char> is_stitched(const SewingPattern& pattern, std::size_t panel) {
  std::vector<char> stitched(pattern.panels[panel].edges_m.size(), 0);
  for (const auto& [first, second] : pattern.stitches) {
    for (const PanelEdge& side : {first, second}) {
      if (side.panel == panel) {
        stitched[side.edge] = 1;
      }
    }
  }
  return stitched;
}

double depth_of(const PatternPanel& panel) {
  sim::Extent extent;
  for (const auto& line : panel.edges_m) {
    extent.add(panel.placed_m(line.front()));
  }
  return extent.middle().z;
}

/// Marks the shoulder seams: those between front and back that are nearly level and near the top. Returns points along
/// them.
std::vector<Vec3> find_shoulder_seams(const SewingPattern& pattern, double top_m, CutPieces& pieces) {
  constexpr std::size_t steps = 8;
  std::vector<Vec3> points_m;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const auto& [first, second] = pattern.stitches[s];
    const PatternPanel &a = pattern.panels[first.panel], &b = pattern.panels[second.panel];
    if (depth_of(a) * depth_of(b) >= 0.0) {
      continue;
    }
    const auto& line = pattern.line_of(first);
    const Vec3 from = a.placed_m(line.front()), to = a.placed_m(line.back()), way = to - from;
    const bool is_beside = from.x * to.x >= 0.0;
    if (is_beside && std::abs(way.x) > shoulder_slope * std::abs(way.y) && length_of(line) < longest_shoulder_m &&
        std::max(from.y, to.y) > top_m - near_top_m) {
      pieces.first_seams.push_back(s);
      for (const sim::Vec2& point : evenly_along(line, steps)) {
        points_m.push_back(a.placed_m(point));
      }
    }
  }
  return points_m;
}

/// How far shoulder seams have to go up to lie above the shoulders of the thin body, which is narrower than they reach.
double rise_over(const std::vector<Vec3>& seams_m, double x_m, const std::vector<Vec3>& thin_m, double half_width_m) {
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
  return rise_m;
}

/// The length of what is sewn to nothing near the top.
double upper_border_m(const SewingPattern& pattern, double top_m) {
  double sum_m = 0.0;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const std::vector<char> stitched = is_stitched(pattern, p);
    const PatternPanel& panel = pattern.panels[p];
    for (std::size_t e = 0; e < stitched.size(); ++e) {
      const auto& line = panel.edges_m[e];
      const double height_m = 0.5 * (panel.placed_m(line.front()).y + panel.placed_m(line.back()).y);
      sum_m += stitched[e] == 0 && height_m > top_m - near_top_m ? length_of(line) : 0.0;
    }
  }
  return sum_m;
}

/// The height of the level nearest to this one that the border goes around and that is not the narrowest beside wider
/// ones only because of that.
double level_for(const BodyMeasures& measures, double border_m, double height_m) {
  double best_m = height_m, least_m = std::numeric_limits<double>::infinity();
  const double chest_m = measures.levels.back().height_m;
  const double fork_m = measures.levels[measures.fork].height_m;
  for (const LevelTape& level : measures.levels) {
    const double off_m = std::abs(level.height_m - height_m);
    const bool is_of_trunk = level.height_m >= fork_m && level.height_m < highest_waist * chest_m + (1.0 - highest_waist) * fork_m;
    if (is_of_trunk && level.girth_m <= border_m && off_m < least_m) {
      least_m = off_m;
      best_m = level.height_m;
    }
  }
  return best_m;
}

Vec3 shift_of(const SewingPattern& pattern, const Wearer& wearer, CutPieces& pieces, std::vector<std::string>& said) {
  const sim::Extent box = sim::extent_of(pieces.placed_m);
  const BodyMeasures& measures = wearer.measures;
  if (!measures.neck_m || measures.levels.empty()) {
    throw InputError("found a body without a neck and arms to be told, expected someone who stands upright");
  }
  const double feet_m = sim::extent_of(wearer.full_m).lower.y, top_m = box.upper.y;
  const bool stands_at_feet = box.lower.y > floor_at_m && top_m > lowest_top_m;
  Vec3 shift = *measures.neck_m - Vec3(0.0, measures.neck_m->y, 0.0);
  shift.y = stands_at_feet ? feet_m : measures.neck_m->y - neck_over_chest_m;
  const std::vector<Vec3> shoulders_m = find_shoulder_seams(pattern, top_m, pieces);
  const std::vector<ArmJoints> arms = arms_of(wearer.joints);
  if (!shoulders_m.empty() && !arms.empty()) {
    const double half_width_m = std::abs(arms[0].shoulder_m.x - shift.x);
    const std::vector<Vec3> thin_m = placed_m(wearer.places, thin_shape(*wearer.rig, wearer.pose));
    shift.y = above_shoulders_m + rise_over(shoulders_m, shift.x, thin_m, half_width_m);
  } else {
    shift.y = level_for(measures, upper_border_m(pattern, top_m), top_m + shift.y) - top_m;
  }
  if (glm::length(shift) > step_m) {
    said.push_back(fmt::format("its pieces are moved by {} m to be about the body", describe_point(shift)));
  }
  return shift;
}

/// Lifts what hangs from a level seam, as a skirt does from the waist of a dress, to where the body is no wider than that
/// seam, if it is wider there. Patterns place skirts below bodices that are longer than the body.
void lift_to_waist(const SewingPattern& pattern, const BodyMeasures& measures, double shoulder_m, CutPieces& pieces) {
  const std::vector<sim::Extent> boxes = panel_boxes(pieces);
  std::set<std::size_t> upper, lower;
  double border_m = 0.0, height_m = 0.0;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    auto [above, below] = pattern.stitches[s];
    if (boxes[above.panel].middle().y < boxes[below.panel].middle().y) {
      std::swap(above, below);
    }
    const Seam& seam = pieces.seams[s];
    const bool is_swapped = pieces.panel_of[seam[0].first] != above.panel;
    const auto at = [&](std::size_t k) { return pieces.placed_m[is_swapped ? seam[k].second : seam[k].first]; };
    const Vec3 way = at(seam.size() - 1) - at(0);
    if (boxes[above.panel].middle().y > boxes[below.panel].middle().y + least_under_m && std::abs(way.y) < level_seam * glm::length(way) &&
        at(0).y < shoulder_m - below_shoulder_m) {
      upper.insert(above.panel);
      lower.insert(below.panel);
      border_m += std::min(length_of(pattern.line_of(above)), length_of(pattern.line_of(below)));
      height_m = std::max(height_m, at(0).y);
    }
  }
  for (std::size_t before = 0; before != lower.size();) {
    before = lower.size();
    for (const auto& [first, second] : pattern.stitches) {
      if (lower.contains(first.panel) != lower.contains(second.panel) && !upper.contains(first.panel) && !upper.contains(second.panel)) {
        lower.insert(first.panel);
        lower.insert(second.panel);
      }
    }
  }
  if (lower.empty() || std::ranges::any_of(upper, [&](std::size_t p) { return lower.contains(p); })) {
    return;
  }
  const double lift_m = level_for(measures, border_m, height_m) - height_m;
  for (std::size_t v = 0; v < pieces.placed_m.size(); ++v) {
    pieces.placed_m[v].y += lower.contains(pieces.panel_of[v]) ? std::max(lift_m, 0.0) : 0.0;
  }
}

/// Pushes panels together that are longer than what they are sewn to, along that seam: the bound allows for it, and cloth
/// folds by itself when it is let go.
void push_ease_together(const SewingPattern& pattern, CutPieces& pieces) {
  const std::vector<Vec3> placed_m = pieces.placed_m;
  const std::vector<sim::Extent> boxes = panel_boxes(pieces);
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    Vec3 along(0.0);
    double own_m = 0.0, other_m = 0.0;
    for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
      for (const bool is_second : {false, true}) {
        const auto& [first, second] = pattern.stitches[s];
        const PanelEdge &own = is_second ? second : first, &other = is_second ? first : second;
        const double length_m = length_of(pattern.line_of(own));
        if (own.panel != p || other.panel == p || length_m < gathered * length_of(pattern.line_of(other))) {
          continue;
        }
        const auto& [begin, end] = std::pair(pieces.seams[s].front(), pieces.seams[s].back());
        const Vec3 way = is_second ? placed_m[end.second] - placed_m[begin.second] : placed_m[end.first] - placed_m[begin.first];
        along += glm::dot(along, way) < 0.0 ? -way : way;
        own_m += length_m;
        other_m += length_of(pattern.line_of(other));
      }
    }
    if (!(glm::length(along) > 0.0)) {
      continue;
    }
    along = glm::normalize(along);
    for (std::size_t v = 0; v < placed_m.size(); ++v) {
      if (pieces.panel_of[v] == p) {
        pieces.placed_m[v] -= (1.0 - other_m / own_m) * glm::dot(placed_m[v] - boxes[p].middle(), along) * along;
      }
    }
  }
}

/// The part of a pattern that goes around an arm.
struct Sleeve {
  std::set<std::size_t> panels;
  Vec3 cuff_m = Vec3(0.0);  ///< its middle
};

/// The sleeve on one side: panels beside the shoulder, with a border far out that is sewn to nothing. Empty if there is none.
Sleeve sleeve_of(const SewingPattern& pattern, const CutPieces& pieces, const Vec3& shift, const Vec3& shoulder_m, double side, double lowest_m) {
  Sleeve sleeve;
  std::vector<double> inner_m(pattern.panels.size(), std::numeric_limits<double>::infinity()), top_m(inner_m.size(), -inner_m[0]);
  for (std::size_t v = 0; v < pieces.placed_m.size(); ++v) {
    const Index p = pieces.panel_of[v];
    inner_m[p] = std::min(inner_m[p], side * pieces.placed_m[v].x);
    top_m[p] = std::max(top_m[p], pieces.placed_m[v].y);
  }
  const auto may_be = [&](std::size_t p) {
    return inner_m[p] > beside_trunk * side * shoulder_m.x && top_m[p] > shoulder_m.y - below_shoulder_m;
  };
  std::vector<std::pair<std::size_t, Vec3>> cuffs;
  double furthest_m = 0.0;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const std::vector<char> stitched = is_stitched(pattern, p);
    const PatternPanel& panel = pattern.panels[p];
    for (std::size_t e = 0; e < stitched.size(); ++e) {
      const Vec3 from = panel.placed_m(panel.edges_m[e].front()) + shift, to = panel.placed_m(panel.edges_m[e].back()) + shift;
      const Vec3 middle = 0.5 * (from + to);
      if (stitched[e] == 0 && std::min(side * from.x, side * to.x) > beside_shoulder * side * shoulder_m.x && middle.y > lowest_m &&
          may_be(p)) {
        cuffs.emplace_back(p, middle);
        furthest_m = std::max(furthest_m, side * middle.x);
      }
    }
  }
  double count = 0.0;
  for (const auto& [p, middle] : cuffs) {
    if (side * middle.x >= outermost * furthest_m) {
      sleeve.panels.insert(p);
      sleeve.cuff_m += middle;
      count += 1.0;
    }
  }
  sleeve.cuff_m /= std::max(count, 1.0);
  for (std::size_t before = 0; before != sleeve.panels.size();) {
    before = sleeve.panels.size();
    for (const auto& [first, second] : pattern.stitches) {
      for (const auto& [a, b] : {std::pair(first.panel, second.panel), std::pair(second.panel, first.panel)}) {
        if (sleeve.panels.contains(a) && inner_m[b] > beside_trunk * side * shoulder_m.x && top_m[b] > lowest_m) {
          sleeve.panels.insert(b);
        }
      }
    }
  }
  return sleeve;
}

/// Raises a sleeve about the shoulder until it is nearly level, as the arm is. Returns the way along it.
Vec3 raise(const Sleeve& sleeve, const Vec3& shoulder_m, double side, CutPieces& pieces) {
  const Vec3 level = Vec3(side, -arms_down, 0.0);
  const Vec3 way = sleeve.cuff_m - shoulder_m;
  if (sleeve.panels.empty() || way.y * side * level.x > level.y * side * way.x) {
    return sleeve.panels.empty() ? level : Vec3(way.x, way.y, 0.0);
  }
  const Vec3 from = glm::normalize(Vec3(way.x, way.y, 0.0)), to = glm::normalize(level);
  const double cosine = glm::dot(from, to), sine = from.x * to.y - from.y * to.x;
  for (std::size_t v = 0; v < pieces.placed_m.size(); ++v) {
    if (sleeve.panels.contains(pieces.panel_of[v])) {
      const Vec3 d = pieces.placed_m[v] - shoulder_m;
      pieces.placed_m[v] = shoulder_m + Vec3(cosine * d.x - sine * d.y, sine * d.x + cosine * d.y, d.z);
    }
  }
  return level;
}

/// A body that goes evenly from one shape to another.
class FramesBetween final : public sim::BodyFrames {
 public:
  FramesBetween(std::vector<Vec3> from_m, std::vector<Vec3> to_m, double frame_rate_hz)
      : from_m_(std::move(from_m)), to_m_(std::move(to_m)), rate_hz_(frame_rate_hz) {}

  std::size_t count() const override { return frames_to_own_shape + 1; }
  double rate_hz() const override { return rate_hz_; }
  void positions_in(std::size_t frame, std::span<Vec3> positions_m) const override {
    const double share = static_cast<double>(frame) / frames_to_own_shape;
    for (std::size_t v = 0; v < positions_m.size(); ++v) {
      positions_m[v] = share == 1.0 ? to_m_[v] : glm::mix(from_m_[v], to_m_[v], share);
    }
  }

 private:
  std::vector<Vec3> from_m_, to_m_;
  double rate_hz_;
};

/// Where the vertices of a body are that leaves no room for cloth.
std::vector<Vec3> own_shape_m(BodySource source, const ShownTime& shown) {
  source.dress = 0;
  return read_body(source, shown).mesh.data->positions_m;
}

/// The bones of a limb, of which there are at least two joints, or none.
std::vector<Index> chain_of(const Wearer& wearer, double side, std::initializer_list<const char*> joints) {
  const std::map<std::string, Index> nodes = joint_nodes(*wearer.rig);
  std::vector<Index> chain;
  for (const char* const joint : joints) {
    const auto node = nodes.find((side > 0.0 ? "left " : "right ") + std::string(joint));
    if (node != nodes.end()) {
      chain.push_back(node->second);
    }
  }
  return chain.size() < 2 ? std::vector<Index>{} : chain;
}

Vec3 begin_m(const Wearer& wearer, const std::vector<Index>& chain) {
  return wearer.places.placement(Vec3(wearer.pose.to_model[chain[0]][3]));
}

void add_bones(const Wearer& wearer, const std::vector<Index>& chain, const Vec3& way, std::vector<TurnedBone>& bones) {
  for (std::size_t k = 1; k < chain.size(); ++k) {
    bones.push_back({chain[k - 1], chain[k], in_file_axes(wearer.places.placement, Vec3(way.x, way.y, 0.0))});
  }
}

/// Raises sleeves, and lets the arms begin in them, or nearly level where there are none.
std::vector<TurnedBone> raise_arms(const SewingPattern& pattern, const Vec3& shift, const Wearer& wearer, CutPieces& pieces) {
  std::vector<TurnedBone> bones;
  for (const double side : {1.0, -1.0}) {
    const std::vector<Index> chain = chain_of(wearer, side, {"arm", "forearm", "hand"});
    if (!chain.empty()) {
      const Vec3 shoulder_m = begin_m(wearer, chain);
      const double lowest_m = wearer.measures.levels[wearer.measures.fork].height_m;
      add_bones(wearer, chain, raise(sleeve_of(pattern, pieces, shift, shoulder_m, side, lowest_m), shoulder_m, side, pieces), bones);
    }
  }
  return bones;
}

/// Lets the legs begin between those panels that reach down furthest and lie on one side, as those of trousers do.
void turn_legs(const Wearer& wearer, const CutPieces& pieces, std::vector<TurnedBone>& bones) {
  const std::vector<sim::Extent> boxes = panel_boxes(pieces);
  const sim::Extent all = sim::extent_of(pieces.placed_m);
  std::vector<TurnedBone> turned;
  for (const double side : {1.0, -1.0}) {
    const std::vector<Index> chain = chain_of(wearer, side, {"upleg", "leg", "foot"});
    Vec3 sum(0.0);
    double count = 0.0;
    for (std::size_t v = 0; v < pieces.placed_m.size() && !chain.empty(); ++v) {
      const sim::Extent& box = boxes[pieces.panel_of[v]];
      const double inner_m = side > 0.0 ? box.lower.x : -box.upper.x;
      if (box.lower.y < all.lower.y + near_hem_m && pieces.placed_m[v].y < box.lower.y + near_hem_m && inner_m > -beyond_middle_m) {
        sum += pieces.placed_m[v];
        count += 1.0;
      }
    }
    if (count == 0.0 || begin_m(wearer, chain).y < all.lower.y + near_hem_m) {
      return;
    }
    add_bones(wearer, chain, sum / count - begin_m(wearer, chain), turned);
  }
  bones.insert(bones.end(), turned.begin(), turned.end());
}

/// Pieces among which none shall touch another or the body.
class Surrounded {
 public:
  Surrounded(const sim::Body& body, double time_s, const Vec3& axis_m, CutPieces& pieces)
      : body_m_(mesh_positions_m(body, time_s)),
        body_triangles_(std::get<sim::BodyMesh>(body.shape).data->triangles),
        axis_m_(axis_m),
        pieces_(pieces) {
    const std::vector<sim::Extent> boxes = panel_boxes(pieces);
    for (std::size_t p = 0; p < boxes.size(); ++p) {
      const auto [a, b, c] = pieces.triangles[pieces.panel_triangles[p]];
      const auto& at = pieces.placed_m;
      const Vec3 normal = glm::cross(at[b] - at[a], at[c] - at[a]), middle = boxes[p].middle() - axis_m;
      const double across = std::hypot(normal.x, normal.z);
      // A piece that lies flat is above what it is drawn to.
      Vec3 way = across > least_level * glm::length(normal) ? Vec3(normal.x, 0.0, normal.z) / across : Vec3(0.0, 1.0, 0.0);
      way = way.y == 0.0 && glm::dot(way, middle) < 0.0 ? -way : way;
      ways_.push_back(way);
      out_m_.push_back(glm::dot(middle, way));
    }
  }

  /// Moves pieces outwards, along their normals, that cross the body or another piece, which then is further in; and
  /// sideways those that cross one which faces the same way. Returns how many moved.
  std::size_t part() {
    std::set<Index> all;
    for (int push = 0; push < most_pushes; ++push) {
      std::set<Index> moved;
      const auto found = crossing(pieces_.placed_m);
      for (const auto& [a, b] : found) {
        if (b && glm::dot(ways_[a], ways_[*b]) > same_way) {
          part_sideways(a, *b);
          all.insert({a, *b});
        } else {
          moved.insert(b && out_m_[*b] >= out_m_[a] ? *b : a);
        }
      }
      if (found.empty()) {
        break;
      }
      move(moved, step_m, pieces_.placed_m);
      for (const Index p : moved) {
        out_m_[p] += step_m;
      }
      all.merge(moved);
    }
    return all.size();
  }

  /// Moves pieces inwards as far as they keep clear of all, so that threads have less to draw: together all that face the
  /// same way, which pass none of each other so.
  void draw_in() {
    std::set<Index> moving;
    for (Index p = 0; p < pieces_.panel_count(); ++p) {
      if (ways_[p].y == 0.0) {
        moving.insert(p);
      }
    }
    while (!moving.empty()) {
      std::vector<Vec3> ahead_m = pieces_.placed_m;
      move(moving, -step_m - clear_m, ahead_m);
      std::set<Index> stopped;
      for (const auto& [a, b] : crossing(ahead_m)) {
        stopped.insert(a);
        stopped.insert(b.value_or(a));
      }
      for (const Index p : moving) {
        if (out_m_[p] < clear_m) {
          stopped.insert(p);
        }
      }
      std::erase_if(moving, [&](Index p) {
        return std::ranges::any_of(stopped, [&](Index other) { return glm::dot(ways_[p], ways_[other]) > same_way; });
      });
      move(moving, -step_m, pieces_.placed_m);
      for (const Index p : moving) {
        out_m_[p] -= step_m;
      }
    }
  }

 private:
  /// Moves two pieces that face the same way apart from each other, half a step each.
  void part_sideways(Index a, Index b) {
    const std::vector<sim::Extent> boxes = panel_boxes(pieces_);
    Vec3 way = boxes[b].middle() - boxes[a].middle();
    way -= glm::dot(way, ways_[a]) * ways_[a];
    way = glm::length(way) > 1e-3 ? glm::normalize(way) : glm::cross(Vec3(0.0, 1.0, 0.0), ways_[a]);
    for (std::size_t v = 0; v < pieces_.placed_m.size(); ++v) {
      const Index p = pieces_.panel_of[v];
      pieces_.placed_m[v] += p == a ? -0.5 * step_m * way : p == b ? 0.5 * step_m * way : Vec3(0.0);
    }
  }

  /// Panels that cross another, or the body.
  std::set<std::pair<Index, std::optional<Index>>> crossing(const std::vector<Vec3>& positions_m) const {
    const Surface cloth = {positions_m, pieces_.triangles};
    const auto panel = [&](Index t) { return pieces_.panel_of[pieces_.triangles[t][0]]; };
    std::set<std::pair<Index, std::optional<Index>>> found;
    for (const CrossingPair& pair : crossing_pairs(cloth, {body_m_, body_triangles_})) {
      found.insert({panel(pair.first), std::nullopt});
    }
    for (const CrossingPair& pair : crossing_pairs(cloth)) {
      found.insert({panel(pair.first), panel(pair.second)});
    }
    return found;
  }

  void move(const std::set<Index>& panels, double by_m, std::vector<Vec3>& positions_m) const {
    for (std::size_t v = 0; v < positions_m.size(); ++v) {
      const Index p = pieces_.panel_of[v];
      positions_m[v] += panels.contains(p) ? by_m * ways_[p] : Vec3(0.0);
    }
  }

  std::vector<Vec3> body_m_;
  std::span<const sim::Triangle> body_triangles_;
  Vec3 axis_m_;
  CutPieces& pieces_;
  std::vector<Vec3> ways_;     ///< per panel, level and outwards
  std::vector<double> out_m_;  ///< per panel, how far out its middle is
};

}  // namespace

double thin_time_s(const Scene& scene) {
  const Dressed dressed = dressed_body(scene);
  return std::get<sim::BodyMesh>(scene.surroundings.bodies[dressed.body].shape).frames->first_s() - 1000.0;
}

std::vector<std::string> place_pieces(const SewingPattern& pattern, CutPieces& pieces, Scene& scene) {
  const Dressed dressed = dressed_body(scene);
  if (dressed.wearer == nullptr) {
    throw InputError("found no body that is dressed, expected someone to sew the pattern on");
  }
  std::vector<std::string> said;
  sim::Body& body = scene.surroundings.bodies[dressed.body];
  const Vec3 shift = shift_of(pattern, *dressed.wearer, pieces, said);
  for (Vec3& position : pieces.placed_m) {
    position += shift;
  }
  if (!pieces.first_seams.empty()) {
    lift_to_waist(pattern, dressed.wearer->measures, sim::extent_of(pieces.placed_m).upper.y, pieces);
  }
  push_ease_together(pattern, pieces);
  std::vector<TurnedBone> bones = raise_arms(pattern, shift, *dressed.wearer, pieces);
  Wearer wearer = *dressed.wearer;
  const double frame_rate_hz = scene.simulation.frame_rate_hz;
  wearer.motion = std::make_shared<const FramesBetween>(
      wearer.full_m, own_shape_m(scene.body_sources[dressed.body], {1.0, frame_rate_hz}), frame_rate_hz);
  wearer.rate_hz = frame_rate_hz;
  const auto grow = [&] {
    std::get<sim::BodyMesh>(body.shape).frames = growing(wearer, turning_back(*wearer.rig, wearer.pose, bones));
  };
  grow();
  const std::size_t moved = Surrounded(body, thin_time_s(scene), *wearer.measures.neck_m, pieces).part();
  turn_legs(wearer, pieces, bones);
  grow();
  Surrounded(body, thin_time_s(scene), *wearer.measures.neck_m, pieces).draw_in();
  if (moved > 0) {
    said.push_back(fmt::format("{} of its {} pieces crossed another or the body where they were placed: moved apart", moved, pieces.panel_count()));
  }
  return said;
}

}  // namespace taut::app
