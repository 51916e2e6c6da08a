#include "app/bodies/body_girths.hpp"

#include "sim/mesh/groups.hpp"

namespace taut::app {
namespace {

constexpr std::size_t levels_of_body = 400;
/// A share of the height: there the largest curve is the trunk, wherever arms are.
constexpr double surely_trunk = 0.55;
/// A part of the trunk of at least this share of the largest is a leg. Smaller parts are hands and folds.
constexpr double share_of_legs = 0.5;
/// A curve beside the trunk of at least this share of its girth is an arm.
constexpr double share_of_arms = 0.15;
constexpr double arms_begin = 1.2;          ///< times the girth a few levels below
constexpr double arms_join = 1.08;          ///< the same where there were arms beside it
constexpr double upper_part = 0.6;          ///< of the trunk's height, from there on
constexpr double below_chest = 0.8;         ///< of the trunk's height, up to there
constexpr double wider_than_waist = 1.03;   ///< a chest, times the smallest girth of the trunk
constexpr double lower_part = 0.5;          ///< of the trunk's height, up to there
constexpr std::ptrdiff_t levels_below = 3;  ///< of where arms or legs begin, where a tape can lie
constexpr double narrower_than_head = 0.85;
constexpr double base_of_neck = 1.35;  ///< times its smallest girth
constexpr double neck_to_head = 0.75;  ///< where the neck is measured
constexpr double share_of_body = 0.8;  ///< of the height: a surface that is as high is the body without hair

constexpr double still_joining = 1.02;    ///< times the girth one level below
constexpr double furthest_ring_m = 0.1;   ///< the middle of an arm from where it was looked for
constexpr double beside_middle = 0.15;    ///< of the upper arm's length
constexpr double beside_joint_m = 0.03;   ///< the end of the shoulder
constexpr int steps_of_armhole = 40;      ///< to the middle of the upper arm
constexpr double still_armhole = 0.98;    ///< times the girth a step before; what shrinks faster is still the shoulder
constexpr double most_of_armhole = 2.0;   ///< times the girth of the arm; what is more is the trunk
constexpr double least_of_armhole = 0.7;  ///< times the girth of the arm or sleeve; what is less is a fold

using Levels = std::vector<LevelTape>;
using Level = Levels::const_iterator;

/// One curve that a level plane cuts out.
struct Piece {
  std::vector<sim::Vec2> hull;
  double tape_m = 0.0;
  sim::Vec2 middle = {0.0, 0.0};
};
using Pieces = std::vector<Piece>;

sim::Vec2 middle_of(const std::vector<sim::Vec2>& points) {
  sim::Extent box;
  for (const sim::Vec2& p : points) box.add({p.x, p.y, 0.0});
  return {box.middle().x, box.middle().y};
}

Pieces pieces_at(const Surface& body, double height_m) {
  Pieces pieces;
  for (const SectionCurve& curve : section_of(body, {{0.0, height_m, 0.0}})) {
    std::vector<sim::Vec2> hull = convex_hull(curve.points_m);
    if (!hull.empty()) {
      const sim::Vec2 middle = middle_of(hull);
      const double tape_m = length_m({hull, true});
      pieces.push_back({std::move(hull), tape_m, middle});
    }
  }
  return pieces;
}

const Piece& largest_of(const Pieces& pieces) { return *std::ranges::max_element(pieces, {}, &Piece::tape_m); }

/// The tape around the pieces that are over or under the trunk, whose hull it replaces. Empty: there are none.
std::optional<LevelTape> tape_around(const Pieces& pieces, double height_m, std::vector<sim::Vec2>& trunk) {
  const sim::Vec2 middle = middle_of(trunk);
  const auto is_of_trunk = [&](const Piece& piece) {
    return is_in_hull(trunk, piece.middle) || is_in_hull(piece.hull, middle);
  };
  Pieces of_trunk;
  std::ranges::copy_if(pieces, std::back_inserter(of_trunk), is_of_trunk);
  if (of_trunk.empty()) return std::nullopt;
  LevelTape tape{.height_m = height_m, .single_m = largest_of(of_trunk).tape_m};
  tape.beside = static_cast<std::size_t>(std::ranges::count_if(
      pieces, [&](const Piece& piece) { return !is_of_trunk(piece) && piece.tape_m > share_of_arms * tape.single_m; }));
  std::erase_if(of_trunk, [&](const Piece& piece) { return piece.tape_m < share_of_legs * tape.single_m; });
  std::vector<sim::Vec2> points;
  sim::Extent box;
  for (const Piece& piece : of_trunk) points.insert(points.end(), piece.hull.begin(), piece.hull.end());
  for (const sim::Vec2& p : points) box.add({p.x, height_m, -p.y});
  trunk = convex_hull(std::move(points));
  tape.is_parted = of_trunk.size() > 1;
  tape.girth_m = length_m({trunk, true});
  tape.middle_m = box.middle();
  tape.half_width_m = 0.5 * box.size().x;
  tape.front_m = box.upper.z;
  return tape;
}

/// Levels from the feet to the top of the head, and where the trunk was looked for.
struct Followed {
  Levels levels;
  std::ptrdiff_t start = 0;
};

Followed follow_trunk(const Surface& body, const sim::Extent& box) {
  const auto height_m = [&](std::size_t k) {
    return box.lower.y + (static_cast<double>(k) + 0.5) / levels_of_body * box.size().y;
  };
  constexpr auto start = static_cast<std::size_t>(surely_trunk * levels_of_body);
  const Pieces first = pieces_at(body, height_m(start));
  Followed followed;
  if (first.empty()) return followed;
  std::vector<sim::Vec2> trunk = largest_of(first).hull;
  const auto add = [&](std::size_t k) {
    const auto tape = tape_around(pieces_at(body, height_m(k)), height_m(k), trunk);
    followed.levels.insert(followed.levels.end(), tape ? 1 : 0, tape.value_or(LevelTape{}));
    return tape.has_value();
  };
  for (std::size_t k = start; k > 0 && add(k - 1); --k) {
  }
  std::ranges::reverse(followed.levels);
  followed.start = static_cast<std::ptrdiff_t>(followed.levels.size());
  trunk = largest_of(first).hull;
  for (std::size_t k = start; k < levels_of_body && add(k); ++k) {
  }
  return followed;
}

/// The surface that is nearly as high as all of it, without others such as hair, shoes and eyes; all if none is.
std::vector<sim::Triangle> skin_of(const Surface& body, double height_m) {
  sim::Groups shells = sim::connected(body.positions_m.size(), body.triangles);
  std::map<sim::Index, sim::Extent> boxes;
  for (const sim::Triangle& t : body.triangles) {
    for (const sim::Index v : t) boxes[shells.find(v)].add(body.positions_m[v]);
  }
  const auto higher = [](const auto& a, const auto& b) { return a.second.size().y < b.second.size().y; };
  const auto highest = std::ranges::max_element(boxes, higher);
  std::vector<sim::Triangle> skin(body.triangles.begin(), body.triangles.end());
  if (highest != boxes.end() && highest->second.size().y > share_of_body * height_m) {
    std::erase_if(skin, [&](const sim::Triangle& t) { return shells.find(t[0]) != highest->first; });
  }
  return skin;
}

/// The levels that tell one part of a body from the next.
struct BodyLandmarks {
  Level fork;     ///< the first of the trunk
  Level armpits;  ///< the first above the trunk
  Level neck;     ///< the smallest below the head; the end if there is none
  Level base;     ///< of the neck
};

/// Whether the trunk below goes over into one with arms.
bool begins_arms(const LevelTape& here, const LevelTape& below) {
  return here.girth_m > (here.beside < below.beside ? arms_join : arms_begin) * below.girth_m;
}

BodyLandmarks landmarks_of(const Followed& body) {
  const Levels& levels = body.levels;
  BodyLandmarks found{levels.begin(), levels.end(), levels.end(), levels.end()};
  const Level start = levels.begin() + body.start;
  const auto leg = std::find_if(std::make_reverse_iterator(start), levels.rend(),
                                [](const LevelTape& level) { return level.is_parted; });
  found.fork = leg.base();
  double head_m = 0.0;
  for (auto level = levels.end(); level != found.fork && found.base == levels.end();) {
    --level;
    head_m = std::max(head_m, level->girth_m);
    if (level->girth_m < narrower_than_head * head_m &&
        (found.neck == levels.end() || level->girth_m < found.neck->girth_m)) {
      found.neck = level;
    } else if (found.neck != levels.end() && level->girth_m > base_of_neck * found.neck->girth_m) {
      found.base = level;
    }
  }
  found.neck = found.base == levels.end() ? levels.end() : found.neck;
  found.armpits = found.base;
  for (auto level = start; found.base - start > levels_below && level + levels_below < found.base; ++level) {
    if (begins_arms(level[levels_below], *level)) {
      found.armpits = level + levels_below;
      while (found.armpits - 1 != start && found.armpits->girth_m > still_joining * (found.armpits - 1)->girth_m) {
        --found.armpits;
      }
      ++found.armpits;
      break;
    }
  }
  return found;
}

Girth named(const char* name, const LevelTape& tape) { return {name, tape.girth_m, tape.height_m}; }

void measure_neck(const Surface& body, const JointPlaces& joints, const BodyLandmarks& at, Level end,
                  BodyMeasures& measures) {
  const auto base = joints.find("neck");
  const auto head = joints.find("head");
  std::optional<LevelTape> tape = at.neck == end ? std::nullopt : std::optional(*at.neck);
  if (base != joints.end()) {
    measures.neck_m = base->second;
  } else if (at.base != end) {
    measures.neck_m = at.base->middle_m;
  }
  if (base != joints.end() && head != joints.end()) {
    const double height_m = glm::mix(base->second.y, head->second.y, neck_to_head);
    const Pieces pieces = pieces_at(body, height_m);
    std::vector<sim::Vec2> largest = pieces.empty() ? std::vector<sim::Vec2>{} : largest_of(pieces).hull;
    tape = pieces.empty() ? std::nullopt : tape_around(pieces, height_m, largest);
  }
  if (tape) measures.girths.push_back(named("neck", *tape));
}

/// The level that is farthest in front of those that are farther than the ones around them and wider than a waist; the
/// farthest of all if none is. A belly may be farther.
Level fullest_in_front(Level first, Level end, double waist_m) {
  const auto by_front = [](const LevelTape& a, const LevelTape& b) { return a.front_m < b.front_m; };
  Level fullest = end;
  for (Level level = first; level != end; ++level) {
    const bool is_fullest_around =
        level->girth_m > wider_than_waist * waist_m &&
        level == std::max_element(level - levels_below, std::min(level + levels_below + 1, end), by_front);
    fullest = is_fullest_around && (fullest == end || by_front(*fullest, *level)) ? level : fullest;
  }
  return fullest == end ? std::max_element(first, end, by_front) : fullest;
}

void measure_trunk(const BodyLandmarks& at, BodyMeasures& measures) {
  if (at.armpits != at.base) measures.girths.push_back(named("upper chest", *(at.armpits - levels_below)));
  const auto share = [&](double of_trunk) {
    return at.fork + static_cast<std::ptrdiff_t>(of_trunk * static_cast<double>(at.armpits - at.fork));
  };
  const auto by_girth = [](const LevelTape& a, const LevelTape& b) { return a.girth_m < b.girth_m; };
  const Level seat = std::max_element(at.fork, share(lower_part), by_girth);
  const double smallest_m = std::min_element(seat, share(below_chest), by_girth)->girth_m;
  const Level chest = fullest_in_front(share(upper_part), at.armpits, smallest_m);
  const Level waist = std::min_element(seat, chest, by_girth);
  measures.waist_m = waist->middle_m;
  for (const auto& [name, level] : {std::pair("chest", chest), {"waist", waist}, {"seat", seat}}) {
    measures.girths.push_back(named(name, *level));
  }
}

void measure_thigh(const Levels& levels, const BodyLandmarks& at, BodyMeasures& measures) {
  if (at.fork - levels.begin() >= levels_below) {
    const LevelTape& thigh = *(at.fork - levels_below);
    measures.girths.push_back({"thigh", thigh.single_m, thigh.height_m});
  }
}

sim::Vec3 lowest_of(const SectionCurve& curve, const CuttingPlane& plane) {
  const auto height_m = [&](const sim::Vec2& p) { return place_in(plane, p).y; };
  return place_in(plane, *std::ranges::min_element(curve.points_m, {}, height_m));
}

/// Across the middle of the upper arm.
std::optional<RingAround> upper_arm(const Surface& surface, const ArmJoints& arm) {
  const sim::Vec3 along = glm::normalize(arm.elbow_m - arm.shoulder_m);
  const auto above = ring_near(surface, {glm::mix(arm.shoulder_m, arm.elbow_m, 0.5 - beside_middle), along});
  const auto below = ring_near(surface, {glm::mix(arm.shoulder_m, arm.elbow_m, 0.5 + beside_middle), along});
  if (!above || !below) return std::nullopt;
  // Joints that are guessed are beside the arm's axis.
  return ring_near(surface,
                   {0.5 * (above->middle_m + below->middle_m), glm::normalize(below->middle_m - above->middle_m)});
}

}  // namespace

std::map<std::string, sim::Index> joint_nodes(const Rig& rig) {
  std::vector<std::string> names;
  for (const RigNode& node : rig.nodes) names.push_back(node.name);
  const std::vector<std::string> parts = parts_of_joints(names);
  std::map<std::string, sim::Index> nodes;
  for (sim::Index n = 0; n < parts.size(); ++n) {
    if (is_main_part(parts[n]) || parts[n] == "neck") nodes.emplace(parts[n], n);
  }
  return nodes;
}

JointPlaces joint_places(const Rig& rig, const RigPose& pose, const Placement& placement) {
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

BodyMeasures measure_body(const Surface& whole, const JointPlaces& joints) {
  const double height_m = sim::extent_of(whole.positions_m).size().y;
  const std::vector<sim::Triangle> skin = skin_of(whole, height_m);
  const Surface body = {whole.positions_m, skin};
  sim::Extent box;
  for (const sim::Triangle& t : skin) {
    for (const sim::Index v : t) box.add(whole.positions_m[v]);
  }
  const Followed followed = follow_trunk(body, box);
  const Levels& levels = followed.levels;
  BodyMeasures measures;
  if (levels.empty()) return measures;
  const BodyLandmarks at = landmarks_of(followed);
  const bool is_someone = !joints.empty() || at.base != levels.end();
  if (!is_someone || at.armpits - at.fork < 10) return measures;
  measure_neck(body, joints, at, levels.end(), measures);
  measure_trunk(at, measures);
  measure_thigh(levels, at, measures);
  if (at.armpits != at.base) {
    measures.levels.assign(levels.begin(), at.armpits);
    measures.fork = static_cast<std::size_t>(at.fork - levels.begin());
  }
  return measures;
}

std::optional<RingAround> ring_near(const Surface& surface, const CuttingPlane& plane, double least_m) {
  std::optional<RingAround> nearest;
  double nearest_m = furthest_ring_m;
  for (const SectionCurve& curve : section_of(surface, plane)) {
    const sim::Vec2 middle = middle_of(curve.points_m);
    if (curve.is_closed && glm::length(middle) < nearest_m && length_m(curve) >= least_m) {
      nearest_m = glm::length(middle);
      nearest = {length_m(curve), tight_tape_m(curve.points_m), place_in(plane, middle), lowest_of(curve, plane)};
    }
  }
  return nearest;
}

std::optional<RingAround> ring_at_shoulder(const Surface& surface, const ArmJoints& arm, double arm_m,
                                           double next_share) {
  const sim::Vec3 along = arm.elbow_m - arm.shoulder_m;
  const sim::Vec3 normal = glm::normalize(glm::normalize(along) + arm.outwards);
  std::optional<RingAround> found;
  for (int step = 0; step < steps_of_armhole; ++step) {
    const sim::Vec3 point_m = arm.shoulder_m + 0.5 * step / steps_of_armhole * along;
    const auto ring = ring_near(surface, {point_m, normal}, least_of_armhole * arm_m);
    const bool is_there = found && ring && ring->tape_m > next_share * found->tape_m;
    if (is_there) break;
    found = ring && ring->tape_m < most_of_armhole * arm_m ? ring : std::nullopt;
  }
  return found;
}

std::optional<RingAround> armhole_of(const Surface& garment, const ArmJoints& arm, double sleeve_m) {
  const auto sleeve = ring_at_shoulder(garment, arm, sleeve_m);
  if (!sleeve) return std::nullopt;
  const sim::Vec3 over_m = arm.shoulder_m + beside_joint_m * arm.outwards;
  const sim::Vec3 front = glm::cross(arm.outwards, sim::Vec3(0.0, 1.0, 0.0));
  const sim::Vec3 normal = glm::cross(front, over_m - sleeve->lowest_m);
  return ring_near(garment, {0.5 * (over_m + sleeve->lowest_m), glm::normalize(normal)},
                   least_of_armhole * sleeve->tape_m);
}

std::vector<ArmJoints> arms_of(const JointPlaces& joints) {
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

void measure_arms(const Surface& body, const JointPlaces& joints, BodyMeasures& measures) {
  std::vector<sim::Vec3> armholes_m;
  std::vector<Girth> of_arm;
  for (const ArmJoints& arm : arms_of(joints)) {
    const auto around = upper_arm(body, arm);
    const auto hole = around ? ring_at_shoulder(body, arm, around->tape_m, still_armhole) : std::nullopt;
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

const Girth* girth_of(const BodyMeasures& measures, const std::string& name) {
  const auto found = std::ranges::find(measures.girths, name, &Girth::name);
  return found == measures.girths.end() ? nullptr : &*found;
}

}  // namespace taut::app
