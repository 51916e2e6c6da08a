#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/bodies/rig_pose.hpp"
#include "app/models/placement.hpp"
#include "app/verify/crossing_pairs.hpp"

namespace taut::app {

/// Where the joints of a body are, in m, by the parts that they move (joint_names.hpp).
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
  sim::Vec3 middle_m = {0, 0, 0};  ///< of the box around what the tape is around
  double half_width_m = 0.0;       ///< along x
  double front_m = 0.0;            ///< the largest z there
};

/// Returns the tape at this height. Empty where there is no body. Arms are what is less than half as large.
std::optional<LevelTape> level_tape(const Surface& body, double height_m);

/// A girth of a body, by its name: "neck", "upper chest", "chest", "waist", "seat", "upper arm", "thigh".
struct Girth {
  std::string name;
  double girth_m = 0.0;
  double height_m = 0.0;
};

/// What is measured of someone who stands upright, arms off the trunk, and looks along z.
struct BodyMeasures {
  std::vector<Girth> girths;         ///< in the order above; what cannot be told is left out
  std::optional<sim::Vec3> neck_m;   ///< the middle of the base of the neck
  std::vector<LevelTape> trunk;      ///< from where legs part up to the arms; empty: there are no arms
  std::optional<sim::Vec3> waist_m;  ///< the middle of the waist
};

/// Measures a body with level tapes. The trunk is between the level where legs part and that where arms
/// begin: the upper chest is right below the arms, the chest its fullest level towards the front in its upper
/// part, the seat its largest in its lower part, the waist its smallest in between (ISO 8559-1). The neck is
/// three quarters of the way from the joint at its base to the head, or else the smallest level below the
/// head; upper arms are measured across their middle, which takes joints; the thigh a little below where legs
/// part. A body without arms, head and joints, such as a table, has none.
BodyMeasures measure_body(const Surface& body, const JointPlaces& joints);

/// Returns the girth of this name; nullptr if there is none.
const Girth* girth_of(const BodyMeasures& measures, const std::string& name);

}  // namespace taut::app
