#include "app/garments/dressing/body_girths.hpp"

#include "app/base/words.hpp"
#include "app/garments/dressing/tuning.hpp"
#include "sim/mesh/groups.hpp"

namespace taut::app {
namespace {

using namespace dressing;

using Levels = std::vector<LevelTape>;
using Level = Levels::const_iterator;

/// One curve that a level plane cuts out.
struct Piece {
  std::vector<sim::Vec2> hull;
  double tape_m = 0.0;
};
using Pieces = std::vector<Piece>;

sim::Vec2 compute_centroid(const std::vector<sim::Vec2>& points) {
  sim::Extent box;
  for (const sim::Vec2& p : points) box.add({p.x, p.y, 0.0});
  return {box.middle().x, box.middle().y};
}

Pieces cut_level(const sim::Surface& body, double height_m) {
  Pieces pieces;
  for (const SectionCurve& curve : cut_section(body, {{0.0, height_m, 0.0}})) {
    std::vector<sim::Vec2> hull = convex_hull(curve.points_m);
    if (!hull.empty()) {
      const double tape_m = length_m({hull, true});
      pieces.push_back({std::move(hull), tape_m});
    }
  }
  return pieces;
}

const Piece& find_longest_piece(const Pieces& pieces) { return *std::ranges::max_element(pieces, {}, &Piece::tape_m); }

/// Returns the tape around the pieces over or under the trunk's hull, and replaces that hull. Empty if there are none.
std::optional<LevelTape> measure_around_trunk(const Pieces& pieces, double height_m, std::vector<sim::Vec2>& trunk) {
  const sim::Vec2 middle = compute_centroid(trunk);
  const auto is_of_trunk = [&](const Piece& piece) {
    return is_in_hull(trunk, compute_centroid(piece.hull)) || is_in_hull(piece.hull, middle);
  };
  Pieces of_trunk;
  std::ranges::copy_if(pieces, std::back_inserter(of_trunk), is_of_trunk);
  if (of_trunk.empty()) return std::nullopt;
  LevelTape tape{.height_m = height_m, .largest_curve_m = find_longest_piece(of_trunk).tape_m};
  tape.arm_count = static_cast<std::size_t>(std::ranges::count_if(pieces, [&](const Piece& piece) {
    return !is_of_trunk(piece) && piece.tape_m > min_arm_girth_fraction * tape.largest_curve_m;
  }));
  std::erase_if(of_trunk,
                [&](const Piece& piece) { return piece.tape_m < min_leg_girth_fraction * tape.largest_curve_m; });
  std::vector<sim::Vec2> points;
  sim::Extent box;
  for (const Piece& piece : of_trunk) points.insert(points.end(), piece.hull.begin(), piece.hull.end());
  for (const sim::Vec2& p : points) box.add({p.x, height_m, -p.y});
  trunk = convex_hull(std::move(points));
  tape.has_legs_apart = of_trunk.size() > 1;
  tape.girth_m = length_m({trunk, true});
  tape.middle_m = box.middle();
  tape.half_width_m = 0.5 * box.size().x;
  tape.front_m = box.upper.z;
  return tape;
}

/// Levels from the feet to the top of the head, and the index of the level where the search for the trunk began.
struct TrunkLevels {
  Levels levels;
  std::ptrdiff_t start = 0;
};

TrunkLevels follow_trunk(const sim::Surface& body, const sim::Extent& box) {
  const auto height_m = [&](std::size_t k) {
    return box.lower.y + (static_cast<double>(k) + 0.5) / level_count * box.size().y;
  };
  const auto start = static_cast<std::size_t>(trunk_search_height_fraction * level_count);
  const Pieces first = cut_level(body, height_m(start));
  TrunkLevels followed;
  if (first.empty()) return followed;
  std::vector<sim::Vec2> trunk = find_longest_piece(first).hull;
  const auto add = [&](std::size_t k) {
    const auto tape = measure_around_trunk(cut_level(body, height_m(k)), height_m(k), trunk);
    followed.levels.insert(followed.levels.end(), tape ? 1 : 0, tape.value_or(LevelTape{}));
    return tape.has_value();
  };
  for (std::size_t k = start; k > 0 && add(k - 1); --k) {
  }
  std::ranges::reverse(followed.levels);
  followed.start = static_cast<std::ptrdiff_t>(followed.levels.size());
  trunk = find_longest_piece(first).hull;
  for (std::size_t k = start; k < static_cast<std::size_t>(level_count) && add(k); ++k) {
  }
  return followed;
}

/// Returns the component that is nearly as high as the whole body, without hair, shoes and eyes. Returns all triangles
/// if no component is so high.
std::vector<sim::Triangle> cut_skin(const sim::Surface& body, double height_m) {
  sim::Groups shells = sim::connect_vertices(body.positions_m.size(), body.triangles);
  std::map<sim::Index, sim::Extent> boxes;
  for (const sim::Triangle& t : body.triangles) {
    for (const sim::Index v : t) boxes[shells.find(v)].add(body.positions_m[v]);
  }
  const auto higher = [](const auto& a, const auto& b) { return a.second.size().y < b.second.size().y; };
  const auto highest = std::ranges::max_element(boxes, higher);
  std::vector<sim::Triangle> skin(body.triangles.begin(), body.triangles.end());
  if (highest != boxes.end() && highest->second.size().y > min_skin_height_fraction * height_m) {
    std::erase_if(skin, [&](const sim::Triangle& t) { return shells.find(t[0]) != highest->first; });
  }
  return skin;
}

/// Levels that separate the parts of a body.
struct BodyLandmarks {
  Level fork;     ///< lowest level of the trunk
  Level armpits;  ///< first level above the trunk
  Level neck;     ///< smallest level below the head; the end if there is none
  Level base;     ///< base of the neck; the end if there is none
};

/// Returns whether arms join the trunk between these levels.
bool begins_arms(const LevelTape& here, const LevelTape& below) {
  return here.girth_m >
         (here.arm_count < below.arm_count ? min_joined_arm_girth_ratio : min_armpit_girth_ratio) * below.girth_m;
}

BodyLandmarks find_landmarks(const TrunkLevels& body) {
  const Levels& levels = body.levels;
  BodyLandmarks landmarks{levels.begin(), levels.end(), levels.end(), levels.end()};
  const Level start = levels.begin() + body.start;
  const auto leg = std::find_if(std::make_reverse_iterator(start), levels.rend(),
                                [](const LevelTape& level) { return level.has_legs_apart; });
  landmarks.fork = leg.base();
  double head_m = 0.0;
  for (auto level = levels.end(); level != landmarks.fork && landmarks.base == levels.end();) {
    --level;
    head_m = std::max(head_m, level->girth_m);
    if (level->girth_m < max_neck_girth_fraction * head_m &&
        (landmarks.neck == levels.end() || level->girth_m < landmarks.neck->girth_m)) {
      landmarks.neck = level;
    } else if (landmarks.neck != levels.end() && level->girth_m > neck_base_girth_ratio * landmarks.neck->girth_m) {
      landmarks.base = level;
    }
  }
  landmarks.neck = landmarks.base == levels.end() ? levels.end() : landmarks.neck;
  landmarks.armpits = landmarks.base;
  for (auto level = start;
       landmarks.base - start > limb_tape_offset_levels && level + limb_tape_offset_levels < landmarks.base; ++level) {
    if (begins_arms(level[limb_tape_offset_levels], *level)) {
      landmarks.armpits = level + limb_tape_offset_levels;
      while (landmarks.armpits - 1 != start &&
             landmarks.armpits->girth_m > joining_girth_ratio * (landmarks.armpits - 1)->girth_m) {
        --landmarks.armpits;
      }
      ++landmarks.armpits;
      break;
    }
  }
  return landmarks;
}

Girth to_girth(const char* name, const LevelTape& tape) { return {name, tape.girth_m, tape.height_m}; }

void measure_neck(const sim::Surface& body, const JointPlaces& joints, const BodyLandmarks& at, Level end,
                  BodyMeasures& measures) {
  const auto base = joints.find("neck");
  const auto head = joints.find("head");
  if (base != joints.end()) {
    measures.neck_m = base->second;
  } else if (at.base != end) {
    measures.neck_m = at.base->middle_m;
  }
  std::optional<LevelTape> tape;
  if (base != joints.end() && head != joints.end()) {
    const double height_m = glm::mix(base->second.y, head->second.y, neck_tape_height_fraction);
    const Pieces pieces = cut_level(body, height_m);
    std::vector<sim::Vec2> largest = pieces.empty() ? std::vector<sim::Vec2>{} : find_longest_piece(pieces).hull;
    tape = measure_around_trunk(pieces, height_m, largest);
  }
  // The joint of the head is so high in some rigs that this is around the jaw.
  if (at.neck != end && (!tape || tape->girth_m >= min_jaw_girth_ratio * at.neck->girth_m)) tape = *at.neck;
  if (tape) measures.girths.push_back(to_girth("neck", *tape));
}

/// Returns the level that reaches farthest forwards among the local maxima that are wider than a waist. Returns the
/// farthest of all if there is no such maximum. A belly may reach farther than the chest.
Level find_fullest_level(Level first, Level end, double waist_m) {
  const auto by_front = [](const LevelTape& a, const LevelTape& b) { return a.front_m < b.front_m; };
  Level fullest = end;
  for (Level level = first; level != end; ++level) {
    const bool is_fullest_around =
        level->girth_m > min_chest_girth_ratio * waist_m &&
        level == std::max_element(level - limb_tape_offset_levels, std::min(level + limb_tape_offset_levels + 1, end),
                                  by_front);
    fullest = is_fullest_around && (fullest == end || by_front(*fullest, *level)) ? level : fullest;
  }
  return fullest == end ? std::max_element(first, end, by_front) : fullest;
}

void measure_trunk(Level first, const BodyLandmarks& at, BodyMeasures& measures) {
  if (at.armpits != at.base)
    measures.girths.push_back(to_girth("upper chest", *(at.armpits - limb_tape_offset_levels)));
  const auto share = [&](double of_trunk) {
    return at.fork + static_cast<std::ptrdiff_t>(of_trunk * static_cast<double>(at.armpits - at.fork));
  };
  const auto by_girth = [](const LevelTape& a, const LevelTape& b) { return a.girth_m < b.girth_m; };
  const auto below = static_cast<std::ptrdiff_t>(seat_below_fork_fraction * level_count);
  const Level lowest = at.fork - std::min(below, at.fork - first);
  const Level seat = std::max_element(lowest, share(max_seat_height_fraction), by_girth);
  const double smallest_m = std::min_element(seat, share(max_waist_height_fraction), by_girth)->girth_m;
  const Level chest = find_fullest_level(share(min_chest_height_fraction), at.armpits, smallest_m);
  const Level waist = std::min_element(seat, chest, by_girth);
  measures.waist_m = waist->middle_m;
  for (const auto& [name, level] : {std::pair("chest", chest), {"waist", waist}, {"seat", seat}}) {
    measures.girths.push_back(to_girth(name, *level));
  }
}

void measure_thigh(const Levels& levels, const BodyLandmarks& at, BodyMeasures& measures) {
  if (at.fork - levels.begin() >= limb_tape_offset_levels) {
    const LevelTape& thigh = *(at.fork - limb_tape_offset_levels);
    measures.girths.push_back({"thigh", thigh.largest_curve_m, thigh.height_m});
  }
}

sim::Vec3 find_lowest_point(const SectionCurve& curve, const CuttingPlane& plane) {
  const auto height_m = [&](const sim::Vec2& p) { return place_in(plane, p).y; };
  return place_in(plane, *std::ranges::min_element(curve.points_m, {}, height_m));
}

/// Returns the ring across the middle of the upper arm.
std::optional<RingAround> find_upper_arm_ring(const sim::Surface& surface, const ArmJoints& arm) {
  const sim::Vec3 along = glm::normalize(arm.elbow_m - arm.shoulder_m);
  const auto above =
      find_ring(surface, {glm::mix(arm.shoulder_m, arm.elbow_m, 0.5 - upper_arm_ring_offset_fraction), along});
  const auto below =
      find_ring(surface, {glm::mix(arm.shoulder_m, arm.elbow_m, 0.5 + upper_arm_ring_offset_fraction), along});
  if (!above || !below) return std::nullopt;
  // Guessed joints lie beside the arm's axis, so that the plane follows the middles of the rings.
  return find_ring(surface,
                   {0.5 * (above->middle_m + below->middle_m), glm::normalize(below->middle_m - above->middle_m)});
}

}  // namespace

std::map<std::string, sim::Index> joint_nodes(const Rig& rig) {
  const std::vector<std::string> parts = parts_of_joints(collect<std::string>(rig.nodes, &RigNode::name));
  std::map<std::string, sim::Index> nodes;
  for (sim::Index n = 0; n < parts.size(); ++n) {
    if (is_main_part(parts[n]) || parts[n] == "neck") nodes.emplace(parts[n], n);
  }
  return nodes;
}

JointPlaces compute_joint_positions(const Rig& rig, const RigPose& pose, const Placement& placement) {
  JointPlaces places;
  for (const auto& [part, node] : joint_nodes(rig)) {
    places.emplace(part, placement(sim::Vec3(pose.to_model[node][3])));
  }
  return places;
}

const LevelTape& BodyMeasures::level_at(double height_m) const {
  const auto above = std::lower_bound(levels.begin(), levels.end() - 1, height_m,
                                      [](const LevelTape& tape, double wanted_m) { return tape.height_m < wanted_m; });
  const bool is_below_nearer = above != levels.begin() && height_m - (above - 1)->height_m < above->height_m - height_m;
  return is_below_nearer ? *(above - 1) : *above;
}

BodyMeasures measure_body(const sim::Surface& whole, const JointPlaces& joints) {
  const double height_m = sim::compute_extent(whole.positions_m).size().y;
  const std::vector<sim::Triangle> skin = cut_skin(whole, height_m);
  const sim::Surface body = {whole.positions_m, skin};
  sim::Extent box;
  for (const sim::Triangle& t : skin) {
    for (const sim::Index v : t) box.add(whole.positions_m[v]);
  }
  const TrunkLevels followed = follow_trunk(body, box);
  const Levels& levels = followed.levels;
  BodyMeasures measures;
  if (levels.empty()) return measures;
  const BodyLandmarks at = find_landmarks(followed);
  const bool is_someone = !joints.empty() || at.base != levels.end();
  if (!is_someone || at.armpits - at.fork < min_trunk_levels) return measures;
  measure_neck(body, joints, at, levels.end(), measures);
  measure_trunk(levels.begin(), at, measures);
  measure_thigh(levels, at, measures);
  if (at.armpits != at.base) {
    measures.levels.assign(levels.begin(), at.armpits);
    measures.fork = static_cast<std::size_t>(at.fork - levels.begin());
  }
  return measures;
}

std::optional<RingAround> find_ring(const sim::Surface& surface, const CuttingPlane& plane, double least_m) {
  std::optional<RingAround> closest_ring;
  double min_distance_m = max_ring_distance_m;
  for (const SectionCurve& curve : cut_section(surface, plane)) {
    const sim::Vec2 middle = compute_centroid(curve.points_m);
    if (curve.is_closed && glm::length(middle) < min_distance_m && length_m(curve) >= least_m) {
      min_distance_m = glm::length(middle);
      closest_ring = {length_m(curve), tight_tape_m(curve.points_m), place_in(plane, middle),
                      find_lowest_point(curve, plane)};
    }
  }
  return closest_ring;
}

std::optional<RingAround> find_shoulder_ring(const sim::Surface& surface, const ArmJoints& arm, double arm_m,
                                             double next_share) {
  const sim::Vec3 along = arm.elbow_m - arm.shoulder_m;
  const sim::Vec3 normal = glm::normalize(glm::normalize(along) + arm.outwards);
  std::optional<RingAround> armhole_ring;
  for (int step = 0; step < armhole_step_count; ++step) {
    const sim::Vec3 point_m = arm.shoulder_m + 0.5 * step / armhole_step_count * along;
    const auto ring = find_ring(surface, {point_m, normal}, min_armhole_ratio * arm_m);
    const bool is_there = armhole_ring && ring && ring->tape_m > next_share * armhole_ring->tape_m;
    if (is_there) break;
    armhole_ring = ring && ring->tape_m < max_armhole_ratio * arm_m ? ring : std::nullopt;
  }
  return armhole_ring;
}

std::optional<RingAround> find_armhole(const sim::Surface& garment, const ArmJoints& arm, double sleeve_m) {
  const auto sleeve = find_shoulder_ring(garment, arm, sleeve_m);
  if (!sleeve) return std::nullopt;
  const sim::Vec3 over_m = arm.shoulder_m + shoulder_end_offset_m * arm.outwards;
  const sim::Vec3 front = glm::cross(arm.outwards, sim::Vec3(0.0, 1.0, 0.0));
  const sim::Vec3 normal = glm::cross(front, over_m - sleeve->lowest_m);
  return find_ring(garment, {0.5 * (over_m + sleeve->lowest_m), glm::normalize(normal)},
                   min_armhole_ratio * sleeve->tape_m);
}

std::vector<ArmJoints> find_arms(const JointPlaces& joints) {
  std::vector<ArmJoints> arms;
  for (const auto& [side, other] : {std::pair<std::string, std::string>("left ", "right "), {"right ", "left "}}) {
    const auto shoulder = joints.find(side + "arm");
    const auto across = joints.find(other + "arm");
    const auto elbow = joints.find(side + "forearm");
    if (shoulder != joints.end() && across != joints.end() && elbow != joints.end() &&
        shoulder->second != elbow->second && shoulder->second != across->second) {
      arms.push_back({shoulder->second, elbow->second, glm::normalize(shoulder->second - across->second)});
    }
  }
  return arms;
}

void measure_arms(const sim::Surface& body, const JointPlaces& joints, BodyMeasures& measures) {
  std::vector<sim::Vec3> armholes_m;
  std::vector<Girth> of_arm;
  for (const ArmJoints& arm : find_arms(joints)) {
    const auto around = find_upper_arm_ring(body, arm);
    const auto hole = around ? find_shoulder_ring(body, arm, around->tape_m, min_next_ring_ratio) : std::nullopt;
    if (hole) {
      armholes_m.push_back(hole->middle_m);
      of_arm = {{"armhole", hole->tape_m, hole->middle_m.y}, {"upper arm", around->tape_m, around->middle_m.y}};
    }
  }
  if (armholes_m.size() == 2) {
    of_arm.insert(of_arm.begin(), {"shoulder width", glm::distance(armholes_m[0], armholes_m[1]), armholes_m[0].y});
  }
  measures.girths.insert(measures.girths.end(), of_arm.begin(), of_arm.end());
}

const Girth* find_girth(const BodyMeasures& measures, const std::string& name) {
  const auto found = std::ranges::find(measures.girths, name, &Girth::name);
  return found == measures.girths.end() ? nullptr : &*found;
}

}  // namespace taut::app
