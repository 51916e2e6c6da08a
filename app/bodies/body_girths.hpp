#pragma once

#include "app/bodies/rig_pose.hpp"
#include "app/models/garment_measures.hpp"

namespace taut::app {

/// Where the joints of a body are, in m, by the parts that they move (rig_pose.hpp).
using JointPlaces = std::map<std::string, sim::Vec3>;

/// Returns the nodes of joints by the parts that they move, of several with the same part the first.
std::map<std::string, sim::Index> joint_nodes(const Rig& rig);

/// Returns where these are.
JointPlaces joint_places(const Rig& rig, const RigPose& pose, const Placement& placement);

/// A level tape around a body, without its arms.
struct LevelTape {
  double height_m = 0.0;
  double girth_m = 0.0;            ///< tight, around both legs where there are two
  double single_m = 0.0;           ///< around the largest curve alone
  bool is_parted = false;          ///< two legs or more
  std::size_t beside = 0;          ///< arms
  sim::Vec3 middle_m = {0, 0, 0};  ///< of the box around what the tape is around
  double half_width_m = 0.0;       ///< along x
  double front_m = 0.0;            ///< the largest z there
};

/// A girth of a body, by its name: "neck", "upper chest", "chest", "waist", "seat", "thigh", "shoulder width",
/// "armhole", "upper arm".
struct Girth {
  std::string name;
  double girth_m = 0.0;
  double height_m = 0.0;
};

/// The measures of a body that stands upright, arms not above the shoulders, and looks along z.
struct BodyMeasures {
  std::vector<Girth> girths;         ///< in the order above; what cannot be told is left out
  std::optional<sim::Vec3> neck_m;   ///< the middle of the base of the neck
  std::vector<LevelTape> levels;     ///< from the feet up to the arms; empty: there are no arms
  std::size_t fork = 0;              ///< the first level above the legs
  std::optional<sim::Vec3> waist_m;  ///< the middle of the waist

  /// The level at this height or the nearest to it. Requires levels.
  const LevelTape& level_at(double height_m) const;
};

/// Measures a body with level tapes. The curve around the middle of the body is followed up and down from level to
/// level, so that arms are left out wherever they hang: a curve that is not over or under it is none of it. The
/// trunk is between the level where it parts into legs and that where arms join it: the upper chest is right below
/// the arms, the chest its fullest level towards the front in its upper part, but for a belly, the seat its largest
/// in its lower part, the waist its smallest in between (ISO 8559-1). The neck is three quarters of the way from the
/// joint at its base to the head, or else the smallest level below the head; the thigh a little below where legs
/// part. Hair and shoes that are surfaces of their own are left out. A body without arms, head and joints, such as a
/// table, has none.
BodyMeasures measure_body(const Surface& body, const JointPlaces& joints);

/// Measures the arms of a body whose joints are known or guessed: around the upper arm, across its middle; the
/// armhole, around the shoulder between trunk and arm; and the shoulders' width between the middles of both armholes.
void measure_arms(const Surface& body, const JointPlaces& joints, BodyMeasures& measures);

/// An arm of a body.
struct ArmJoints {
  sim::Vec3 shoulder_m, elbow_m;
  sim::Vec3 outwards;  ///< from the other shoulder, of length 1
};

/// Returns the arms whose joints are known on both sides.
std::vector<ArmJoints> arms_of(const JointPlaces& joints);

/// A closed curve around an arm or a sleeve.
struct RingAround {
  double length_m = 0.0;
  double tape_m = 0.0;  ///< tight
  sim::Vec3 middle_m, lowest_m;
};

/// Returns the ring whose middle is nearest to the plane's point, of those that are at least so long; empty if none is
/// near.
std::optional<RingAround> ring_near(const Surface& surface, const CuttingPlane& plane, double least_m = 0.0);

/// Returns the ring around the shoulder: the first from its joint outwards that is around the arm alone, whose girth
/// is given, and from which on the next one, a few millimetres further, is not smaller than this share; on a plane
/// between across the arm and across the shoulders. Empty where there is none.
std::optional<RingAround> ring_at_shoulder(const Surface& surface, const ArmJoints& arm, double arm_m,
                                           double next_share = 0.0);

/// Returns the ring of a garment with sleeves from where sleeve and trunk part below the arm to over the shoulder.
std::optional<RingAround> armhole_of(const Surface& garment, const ArmJoints& arm, double sleeve_m);

/// Returns the girth of this name; nullptr if there is none.
const Girth* girth_of(const BodyMeasures& measures, const std::string& name);

}  // namespace taut::app
