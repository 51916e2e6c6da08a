#pragma once

#include "app/bodies/rig_pose.hpp"
#include "app/models/hanging/garment_measures.hpp"

namespace taut::app {

/// Positions of a body's joints in m, by the part that each joint moves (rig_pose.hpp).
using JointPlaces = std::map<std::string, sim::Vec3>;

/// Returns the nodes of joints, by the part that each joint moves. The first of several joints of one part is taken.
std::map<std::string, sim::Index> joint_nodes(const Rig& rig);

/// Returns the positions of the joints in this pose.
JointPlaces compute_joint_positions(const Rig& rig, const RigPose& pose, const Placement& placement);

/// A level tape around a body, without its arms.
struct LevelTape {
  double height_m = 0.0;
  double girth_m = 0.0;            ///< tight girth, around both legs where there are two
  double largest_curve_m = 0.0;    ///< girth of the largest curve alone
  bool has_legs_apart = false;     ///< true if there are two legs or more
  std::size_t arm_count = 0;       ///< count of arms beside the trunk
  sim::Vec3 middle_m = {0, 0, 0};  ///< middle of the box around the measured curves
  double half_width_m = 0.0;       ///< half the width along x
  double front_m = 0.0;            ///< largest z of the measured curves
};

/// A girth of a body, by its name: "neck", "upper chest", "chest", "waist", "seat", "thigh", "shoulder width",
/// "armhole", "upper arm".
struct Girth {
  std::string name;
  double girth_m = 0.0;
  double height_m = 0.0;
};

/// Measures of a body that stands upright, looks along z and does not raise its arms above the shoulders.
struct BodyMeasures {
  std::vector<Girth> girths;         ///< girths in the order above, without those that cannot be measured
  std::optional<sim::Vec3> neck_m;   ///< middle of the base of the neck
  std::vector<LevelTape> levels;     ///< levels from the feet up to the armpits; empty if there are no arms
  std::size_t fork = 0;              ///< index of the first level above the legs
  std::optional<sim::Vec3> waist_m;  ///< middle of the waist

  /// Returns the level nearest to this height. Requires levels.
  const LevelTape& level_at(double height_m) const;
};

/// Measures a body with level tapes. The curve around the middle of the body is followed up and down from level to
/// level. Curves that are not over or under it are left out, so that arms are not measured wherever they hang. The
/// trunk begins where it parts into legs and ends where arms join it. The upper chest is right below the arms. The
/// chest is the level in the trunk's upper part that reaches farthest forwards, apart from a belly. The seat is the
/// largest level in its lower part or right below it, around both thighs. The waist is the smallest level between these
/// two (ISO 8559-1). The neck is three quarters of the way from the joint at its base to the head's, or the smallest
/// level below the head if that is around the jaw or no joints are known.
/// The thigh is a little below the level where the legs part. Hair and shoes that are components of their own are left
/// out. A body without arms, head and joints, such as a table, has no girths.
BodyMeasures measure_body(const sim::Surface& body, const JointPlaces& joints);

/// Measures the arms of a body whose joints are known or guessed. The upper arm is measured across its middle, the
/// armhole around the shoulder between trunk and arm. The shoulder width is the distance of the middles of both
/// armholes.
void measure_arms(const sim::Surface& body, const JointPlaces& joints, BodyMeasures& measures);

struct ArmJoints {
  sim::Vec3 shoulder_m, elbow_m;
  sim::Vec3 outwards;  ///< unit vector from the other shoulder to this one
};

/// Returns the arms whose joints are known on both sides.
std::vector<ArmJoints> find_arms(const JointPlaces& joints);

/// A closed curve around an arm or a sleeve.
struct RingAround {
  double length_m = 0.0;
  double tape_m = 0.0;  ///< length of a tight tape
  sim::Vec3 middle_m, lowest_m;
};

/// Returns the ring whose middle is nearest to the plane's point, among rings that are at least `least_m` long. Empty
/// if none is near.
std::optional<RingAround> find_ring(const sim::Surface& surface, const CuttingPlane& plane, double least_m = 0.0);

/// Returns the first ring from the shoulder joint outwards that goes around the arm alone, whose girth is `arm_m`. Its
/// plane is halfway between across the arm and across the shoulders. The next ring, a few millimetres further out, must
/// be longer than `next_share` times this one. Empty if there is none.
std::optional<RingAround> find_shoulder_ring(const sim::Surface& surface, const ArmJoints& arm, double arm_m,
                                             double next_share = 0.0);

/// Returns the armhole of a garment with sleeves. Its plane goes through the point below the arm where sleeve and trunk
/// part, and through the end of the shoulder.
std::optional<RingAround> find_armhole(const sim::Surface& garment, const ArmJoints& arm, double sleeve_m);

/// Returns nullptr if there is no girth of this name.
const Girth* find_girth(const BodyMeasures& measures, const std::string& name);

}  // namespace taut::app
