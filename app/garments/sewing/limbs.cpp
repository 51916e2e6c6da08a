#include "app/garments/sewing/placing.hpp"
#include "app/garments/sewing/tuning.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec3;
using namespace sewing;

/// Part of a pattern that goes around an arm.
struct Sleeve {
  std::set<std::size_t> panels;
  Vec3 cuff_m = Vec3(0.0);  ///< middle of the cuff
};

/// Returns the sleeve on one side: panels beside the trunk that are sewn together, one of them near the shoulder, with
/// an unsewn border beyond it. Empty if there is none.
Sleeve find_sleeve(const SewingPattern& pattern, const CutPieces& pieces, const Vec3& shift, const Vec3& shoulder_m,
                   double side) {
  const std::vector<sim::Extent> boxes = panel_boxes(pieces);
  const auto is_beside = [&](std::size_t p) {
    return boxes[p].middle().y < shoulder_m.y + over_shoulder_m &&
           (side > 0.0 ? boxes[p].lower.x : -boxes[p].upper.x) > beside_trunk * side * shoulder_m.x;
  };
  Sleeve sleeve;
  for (std::size_t p = 0; p < boxes.size(); ++p) {
    if (is_beside(p) && boxes[p].upper.y > shoulder_m.y - below_shoulder_m && !sleeve.panels.contains(p)) {
      sleeve.panels.merge(pattern.sewn_with({p}, is_beside));
    }
  }
  std::vector<Vec3> ends;
  for (const PanelEdge& edge : pattern.unsewn_edges()) {
    const auto [from, to] = pattern.placed_ends_m(edge);
    const double offset_m = std::min(side * (from + shift).x, side * (to + shift).x);
    if (sleeve.panels.contains(edge.panel) && offset_m > side * shoulder_m.x) ends.push_back(0.5 * (from + to) + shift);
  }
  if (ends.empty()) return {};
  for (const Vec3& end : ends) sleeve.cuff_m += end / static_cast<double>(ends.size());
  return sleeve;
}

/// Turns a sleeve about the shoulder so that it points along the arm.
void turn(const Sleeve& sleeve, const Vec3& shoulder_m, const Vec3& along, CutPieces& pieces) {
  const Vec3 way = sleeve.cuff_m - shoulder_m;
  const Vec3 from = glm::normalize(Vec3(way.x, way.y, 0.0)), to = glm::normalize(along);
  const double cosine = glm::dot(from, to), sine = from.x * to.y - from.y * to.x;
  for (std::size_t v = 0; v < pieces.placed_m.size(); ++v) {
    if (sleeve.panels.contains(pieces.panel_of[v])) {
      const Vec3 d = pieces.placed_m[v] - shoulder_m;
      pieces.placed_m[v] = shoulder_m + Vec3(cosine * d.x - sine * d.y, sine * d.x + cosine * d.y, d.z);
    }
  }
}

/// Returns the direction of arms while the body is thin: nearly level, and below shoulder seams that go on over the
/// arms, as in a poncho.
Vec3 along_arm(const CutPieces& pieces, const Vec3& shoulder_m, double side) {
  double slope = 0.0;
  for (const std::size_t s : pieces.first_seams) {
    Vec3 inner_m = pieces.placed_m[pieces.seams[s].front().first] - shoulder_m;
    Vec3 outer_m = pieces.placed_m[pieces.seams[s].back().first] - shoulder_m;
    if (side * inner_m.x > side * outer_m.x) std::swap(inner_m, outer_m);
    if (side * inner_m.x < 0.0 && side * outer_m.x > over_arm_m) {
      slope = std::max(slope, -outer_m.y / (side * outer_m.x));
    }
  }
  return {side, -arms_down - slope, 0.0};
}

void add_legs(const Wearer& wearer, const CutPieces& pieces, std::vector<TurnedBone>& bones) {
  const std::vector<sim::Extent> boxes = panel_boxes(pieces);
  const double hem_m = sim::compute_extent(pieces.placed_m).lower.y + near_hem_m;
  for (const sim::Extent& box : boxes) {
    const bool is_of_one_leg = std::abs(box.middle().x) > min_leg_offset_widths * box.size().x;
    if (box.lower.y < hem_m && !is_of_one_leg) return;
  }
  for (const double side : {1.0, -1.0}) {
    const std::optional<Limb> leg = find_limb(wearer, side, leg_parts);
    Vec3 sum(0.0);
    double count = 0.0;
    for (std::size_t v = 0; v < pieces.placed_m.size(); ++v) {
      if (pieces.placed_m[v].y < hem_m && side * boxes[pieces.panel_of[v]].middle().x > 0.0) {
        sum += pieces.placed_m[v];
        count += 1.0;
      }
    }
    if (!leg || count == 0.0 || leg->begin_m.y < hem_m) return;
    const Vec3 way = sum / count - leg->begin_m;
    turn_limb(wearer, *leg, {way.x, way.y, 0.0}, bones);
  }
}

}  // namespace

void turn_sleeves(const SewingPattern& pattern, const Vec3& shift, const Wearer& wearer, CutPieces& pieces) {
  for (const double side : {1.0, -1.0}) {
    const std::optional<Limb> arm = find_limb(wearer, side, arm_parts);
    if (!arm) continue;
    const Sleeve sleeve = find_sleeve(pattern, pieces, shift, arm->begin_m, side);
    if (!sleeve.panels.empty()) turn(sleeve, arm->begin_m, along_arm(pieces, arm->begin_m, side), pieces);
  }
}

std::vector<TurnedBone> turned_limbs(const Wearer& wearer, const CutPieces& pieces) {
  std::vector<TurnedBone> bones;
  for (const double side : {1.0, -1.0}) {
    const std::optional<Limb> arm = find_limb(wearer, side, arm_parts);
    if (arm) turn_limb(wearer, *arm, along_arm(pieces, arm->begin_m, side), bones);
  }
  add_legs(wearer, pieces, bones);
  return bones;
}

}  // namespace taut::app
