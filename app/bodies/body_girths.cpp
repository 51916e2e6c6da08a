#include "app/bodies/body_girths.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/bodies/joint_names.hpp"
#include "app/models/section.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

constexpr std::size_t levels_of_body = 400;
/// A curve of at least this share of the largest is a leg, or the trunk itself; arms are less.
constexpr double share_of_legs = 0.5;
constexpr double highest_fork = 0.65;       ///< of the height
constexpr double arms_begin = 1.2;          ///< times the girth one level below
constexpr double upper_part = 0.6;          ///< of the trunk's height, from there on
constexpr double lower_part = 0.5;          ///< of the trunk's height, up to there
constexpr std::ptrdiff_t levels_below = 3;  ///< of where arms or legs begin, where a tape can lie
constexpr double narrower_than_head = 0.85;
constexpr double base_of_neck = 1.35;  ///< times its smallest girth
constexpr double neck_to_head = 0.75;  ///< where the neck is measured

using Levels = std::vector<LevelTape>;
using Level = Levels::const_iterator;

Levels levels_of(const Surface& body, const sim::Extent& box) {
  Levels levels;
  for (std::size_t k = 0; k < levels_of_body; ++k) {
    const double share = (static_cast<double>(k) + 0.5) / levels_of_body;
    if (const auto tape = level_tape(body, box.lower.y + share * box.size().y)) {
      levels.push_back(*tape);
    }
  }
  return levels;
}

/// The levels that tell one part of a body from the next.
struct BodyLandmarks {
  Level fork;     ///< the first of the trunk
  Level armpits;  ///< the first above the trunk
  Level neck;     ///< the smallest below the head; the end if there is none
  Level base;     ///< of the neck
};

BodyLandmarks landmarks_of(const Levels& levels) {
  const auto share = [&](double of_height) {
    return levels.begin() + static_cast<std::ptrdiff_t>(of_height * static_cast<double>(levels.size()));
  };
  BodyLandmarks found{levels.begin(), levels.end(), levels.end(), levels.end()};
  for (auto level = levels.begin(); level != share(highest_fork); ++level) {
    found.fork = level->is_parted ? level + 1 : found.fork;
  }
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
  found.armpits =
      std::adjacent_find(found.fork, found.base, [](const LevelTape& below, const LevelTape& here) {
        return here.girth_m > arms_begin * below.girth_m;
      });
  found.armpits += found.armpits == found.base ? 0 : 1;
  return found;
}

Girth named(const char* name, const LevelTape& tape) {
  return {name, tape.girth_m, tape.height_m};
}

/// Around an arm, across the middle between two joints. Empty where nothing is.
std::optional<Girth> upper_arm(const Surface& body, const JointPlaces& joints) {
  for (const std::string side : {"left ", "right "}) {
    const auto shoulder = joints.find(side + "arm");
    const auto elbow = joints.find(side + "forearm");
    if (shoulder == joints.end() || elbow == joints.end() || shoulder->second == elbow->second) {
      continue;
    }
    const sim::Vec3 middle_m = 0.5 * (shoulder->second + elbow->second);
    for (const SectionCurve& curve :
         section_of(body, {middle_m, glm::normalize(elbow->second - shoulder->second)})) {
      if (curve.is_closed && is_around_point(curve)) {
        return Girth{"upper arm", tight_tape_m(curve.points_m), middle_m.y};
      }
    }
  }
  return std::nullopt;
}

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
    tape = level_tape(body, glm::mix(base->second.y, head->second.y, neck_to_head));
  }
  if (tape) {
    measures.girths.push_back(named("neck", *tape));
  }
}

void measure_trunk(const BodyLandmarks& at, BodyMeasures& measures) {
  if (at.armpits != at.base) {
    measures.girths.push_back(named("upper chest", *(at.armpits - levels_below)));
    measures.trunk.assign(at.fork, at.armpits);
  }
  const auto share = [&](double of_trunk) {
    return at.fork + static_cast<std::ptrdiff_t>(of_trunk * static_cast<double>(at.armpits - at.fork));
  };
  const auto by_girth = [](const LevelTape& a, const LevelTape& b) { return a.girth_m < b.girth_m; };
  const auto by_front = [](const LevelTape& a, const LevelTape& b) { return a.front_m < b.front_m; };
  const Level chest = std::max_element(share(upper_part), at.armpits, by_front);
  const Level seat = std::max_element(at.fork, share(lower_part), by_girth);
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

}  // namespace

std::map<std::string, sim::Index> joint_nodes(const Rig& rig) {
  std::vector<std::string> names;
  for (const RigNode& node : rig.nodes) {
    names.push_back(node.name);
  }
  const std::vector<std::string> parts = parts_of_joints(names);
  std::map<std::string, sim::Index> nodes;
  for (sim::Index n = 0; n < parts.size(); ++n) {
    if (is_main_part(parts[n]) || parts[n] == "neck") {
      nodes.emplace(parts[n], n);
    }
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

std::optional<LevelTape> level_tape(const Surface& body, double height_m) {
  std::vector<SectionCurve> curves = section_of(body, {{0.0, height_m, 0.0}});
  std::vector<double> tapes_m;
  for (const SectionCurve& curve : curves) {
    tapes_m.push_back(tight_tape_m(curve.points_m));
  }
  if (curves.empty()) {
    return std::nullopt;
  }
  LevelTape tape{.height_m = height_m, .single_m = *std::max_element(tapes_m.begin(), tapes_m.end())};
  std::vector<sim::Vec2> points_m;
  sim::Extent box;
  std::size_t parts = 0;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (tapes_m[c] >= share_of_legs * tape.single_m) {
      ++parts;
      points_m.insert(points_m.end(), curves[c].points_m.begin(), curves[c].points_m.end());
    }
  }
  for (const sim::Vec2& p : points_m) {
    box.add({p.x, height_m, -p.y});
  }
  tape.is_parted = parts > 1;
  tape.girth_m = parts > 1 ? tight_tape_m(points_m) : tape.single_m;
  tape.middle_m = box.middle();
  tape.half_width_m = 0.5 * box.size().x;
  tape.front_m = box.upper.z;
  return tape;
}

BodyMeasures measure_body(const Surface& body, const JointPlaces& joints) {
  const Levels levels = levels_of(body, sim::extent_of(body.positions_m));
  BodyMeasures measures;
  if (levels.empty()) {
    return measures;
  }
  const BodyLandmarks at = landmarks_of(levels);
  const bool is_someone = !joints.empty() || at.base != levels.end();
  if (!is_someone || at.armpits - at.fork < 10) {
    return measures;
  }
  measure_neck(body, joints, at, levels.end(), measures);
  measure_trunk(at, measures);
  if (const auto arm = upper_arm(body, joints)) {
    measures.girths.push_back(*arm);
  }
  measure_thigh(levels, at, measures);
  return measures;
}

const Girth* girth_of(const BodyMeasures& measures, const std::string& name) {
  const auto found = std::find_if(measures.girths.begin(), measures.girths.end(),
                                  [&](const Girth& girth) { return girth.name == name; });
  return found == measures.girths.end() ? nullptr : &*found;
}

}  // namespace taut::app
