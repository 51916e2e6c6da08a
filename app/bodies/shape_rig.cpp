#include "app/bodies/shape_rig.hpp"

#include <glm/ext/matrix_transform.hpp>

#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

// Shares of the trunk's half width at the arms, from its middle.
constexpr double shoulder_at = 0.85;
constexpr double hip_at = 0.5;
constexpr double shoulder_height = 0.55;  ///< of the way from below the arms to the base of the neck
constexpr double elbow_at = 0.45;         ///< of the way from the shoulder to the finger tips
constexpr double around_elbow = 0.05;     ///< of that
constexpr double hips_above_fork = 0.12;  ///< of the trunk's height
constexpr double beside_trunk = 1.03;     ///< times its half width: from there on it is an arm
constexpr double hands_below_fork = 0.1;  ///< of the height, at most; what is further down are legs
constexpr double feet_below = 0.04;       ///< of the height
constexpr double end_of_bone = 0.9;       ///< of its length: what is further follows the joint at its end

enum class Limb { trunk, arm, leg };

struct Bone {
  sim::Index begin = 0;
  sim::Index end = 0;
  Limb limb = Limb::trunk;
};

class Maker {
 public:
  Maker(const Surface& body, const BodyMeasures& measures)
      : body_(body),
        measures_(measures),
        below_arms_(measures.levels.back()),
        neck_m_(*measures.neck_m),
        box_(sim::extent_of(body.positions_m)) {}

  std::optional<Rig> make() {
    const LevelTape& fork = measures_.levels[measures_.fork];
    const double half_width_m = below_arms_.half_width_m;
    const sim::Vec3 hips_m =
        fork.middle_m + sim::Vec3(0.0, hips_above_fork * (below_arms_.height_m - fork.height_m), 0.0);
    const sim::Index hips = add("Hips", no_node, hips_m, Limb::trunk);
    const sim::Index neck = add("Neck", hips, neck_m_, Limb::trunk);
    add("Head", neck, {neck_m_.x, 0.5 * (neck_m_.y + box_.upper.y), neck_m_.z}, Limb::trunk);
    for (const double side : {1.0, -1.0}) {
      const std::string name = side > 0.0 ? "Left" : "Right";
      const sim::Vec3 shoulder_m = glm::mix(below_arms_.middle_m, neck_m_, shoulder_height) +
                                   sim::Vec3(side * shoulder_at * half_width_m, 0.0, 0.0);
      const std::optional<sim::Vec3> hand_m = farthest_of_arm(side, shoulder_m);
      const std::optional<sim::Vec3> foot_m = middle_of_foot(side);
      if (!hand_m || !foot_m) return std::nullopt;
      const sim::Index arm = add(name + "Arm", neck, shoulder_m, Limb::arm);
      const sim::Index forearm = add(name + "ForeArm", arm, elbow_of(side, shoulder_m, *hand_m), Limb::arm);
      add(name + "Hand", forearm, *hand_m, Limb::arm);
      const sim::Index leg =
          add(name + "UpLeg", hips, hips_m + sim::Vec3(side * hip_at * half_width_m, 0.0, 0.0), Limb::leg);
      add(name + "Foot", leg, *foot_m, Limb::leg);
    }
    follow();
    return std::move(rig_);
  }

 private:
  sim::Index add(const std::string& name, sim::Index parent, const sim::Vec3& place_m, Limb limb) {
    const auto node = static_cast<sim::Index>(rig_.nodes.size());
    const sim::Vec3 from_m = parent == no_node ? sim::Vec3(0.0) : places_m_[parent];
    rig_.nodes.push_back({name, parent, glm::translate(glm::dmat4(1.0), place_m - from_m)});
    rig_.bones.push_back({node, glm::translate(glm::dmat4(1.0), -place_m)});
    places_m_.push_back(place_m);
    if (parent != no_node) bones_.push_back({parent, node, limb});
    return node;
  }

  bool is_above_trunk(const sim::Vec3& p) const { return p.y > below_arms_.height_m; }

  /// Beside the trunk and the legs, and beside the trunk's upper end of a point that is above it.
  bool is_beside_trunk(const sim::Vec3& p) const {
    if (p.y < measures_.levels[measures_.fork].height_m - hands_below_fork * box_.size().y) return false;
    const LevelTape& level = measures_.level_at(p.y);
    return std::abs(p.x - level.middle_m.x) > beside_trunk * level.half_width_m;
  }

  bool may_follow(const sim::Vec3& p, Limb limb) const {
    if (is_above_trunk(p)) return limb != Limb::leg;
    return is_beside_trunk(p) ? limb == Limb::arm : limb != Limb::arm;
  }

  std::optional<sim::Vec3> farthest_of_arm(double side, const sim::Vec3& shoulder_m) const {
    std::optional<sim::Vec3> farthest_m;
    double most_m = 0.0;
    for (const sim::Vec3& p : body_.positions_m) {
      const double from_m = glm::distance(p, shoulder_m);
      const bool is_of_arm = is_beside_trunk(p) && side * (p.x - neck_m_.x) > 0.0;
      if (is_of_arm && from_m > most_m) {
        most_m = from_m;
        farthest_m = p;
      }
    }
    return farthest_m;
  }

  /// The middle of what of the arm is as far from the shoulder as elbows are.
  sim::Vec3 elbow_of(double side, const sim::Vec3& shoulder_m, const sim::Vec3& hand_m) const {
    const double length_m = glm::distance(shoulder_m, hand_m);
    sim::Extent elbow;
    for (const sim::Vec3& p : body_.positions_m) {
      const double share = glm::distance(p, shoulder_m) / length_m;
      if (is_beside_trunk(p) && side * (p.x - neck_m_.x) > 0.0 && std::abs(share - elbow_at) < around_elbow) {
        elbow.add(p);
      }
    }
    return elbow.lower.x > elbow.upper.x ? glm::mix(shoulder_m, hand_m, elbow_at) : elbow.middle();
  }

  std::optional<sim::Vec3> middle_of_foot(double side) const {
    sim::Extent foot;
    for (const sim::Vec3& p : body_.positions_m) {
      if (side * (p.x - neck_m_.x) > 0.0 && p.y < box_.lower.y + feet_below * box_.size().y) foot.add(p);
    }
    return foot.lower.x > foot.upper.x ? std::nullopt : std::optional(foot.middle());
  }

  void follow() {
    rig_.in_part.assign(body_.positions_m.begin(), body_.positions_m.end());
    rig_.parts = {{0, "", 0, rig_.in_part.size(), true}};
    for (std::size_t v = 0; v < rig_.in_part.size(); ++v) {
      const sim::Vec3& p = rig_.in_part[v];
      double nearest_m = std::numeric_limits<double>::infinity();
      sim::Index joint = 0;
      for (const Bone& bone : bones_) {
        const sim::Vec3 along = places_m_[bone.end] - places_m_[bone.begin];
        const double share = std::clamp(glm::dot(p - places_m_[bone.begin], along) / glm::dot(along, along), 0.0, 1.0);
        const double distance_m = glm::distance(p, places_m_[bone.begin] + share * along);
        if (may_follow(p, bone.limb) && distance_m < nearest_m) {
          nearest_m = distance_m;
          joint = share > end_of_bone ? bone.end : bone.begin;
        }
      }
      rig_.influences.push_back({v, joint, 1.0});
    }
  }

  const Surface& body_;
  const BodyMeasures& measures_;
  const LevelTape& below_arms_;
  sim::Vec3 neck_m_;
  sim::Extent box_;
  Rig rig_;
  std::vector<sim::Vec3> places_m_;
  std::vector<Bone> bones_;
};

}  // namespace

std::optional<Rig> rig_by_shape(const Surface& body, const BodyMeasures& measures) {
  return measures.levels.empty() || !measures.neck_m ? std::nullopt : Maker(body, measures).make();
}

BodyMeasures measures_of(const Surface& body, const JointPlaces& joints) {
  BodyMeasures measures = measure_body(body, joints);
  const std::optional<Rig> guessed = joints.empty() ? rig_by_shape(body, measures) : std::nullopt;
  measure_arms(body, guessed ? joint_places(*guessed, stored_pose(*guessed), {}) : joints, measures);
  return measures;
}

}  // namespace taut::app
