#pragma once

#include "app/bodies/frame_source.hpp"
#include "app/garments/dressing/body_girths.hpp"

namespace taut::app {

/// Returns a thin shape of the body: each vertex of the pose is moved most of the way to the nearest points on its
/// bones, weighted by its influences. A bone goes from a joint to each joint below it that vertices follow; a joint
/// without bones is a point. Positions are in the file's unit and axes, per vertex of the rig. Throws InputError if
/// vertices follow no joint.
std::vector<sim::Vec3> compute_thin_shape(const Rig& rig, const RigPose& pose);

/// A body that is to be dressed, as load_bodies() keeps it.
struct Wearer {
  std::shared_ptr<const Rig> rig;
  FileVertexPlaces places;
  RigPose pose;                                        ///< pose in which the run begins
  std::vector<sim::Vec3> full_m;                       ///< positions of the vertices in this pose
  std::shared_ptr<const sim::BodyFrames> motion = {};  ///< motion of the run; null if the body stands still
  std::vector<sim::Vec3> own_m = {};                   ///< shape that a body without motion takes in the end, if any
  double rate_hz = 60.0;                               ///< frame rate of the motion
  double duration_s = 0.0;                             ///< duration of the growth, before 0 s
  BodyMeasures measures = {};                          ///< measures in the stored pose
  JointPlaces stored_joints = {};                      ///< joints in the stored pose
  JointPlaces joints = {};                             ///< joints in `pose`
  std::shared_ptr<const sim::BodyFrames> frames = {};  ///< growth in `pose`, then the motion
};

/// Bodies of a scene with the meshes of their files, in the scene's order.
struct LoadedBodies {
  std::vector<sim::Body> all = {};
  std::vector<std::shared_ptr<const Wearer>> wearers = {};  ///< wearer of each body; null or missing: not dressed
  std::vector<std::filesystem::path> files_read = {};       ///< also files that the scene does not name itself
  std::vector<std::string> remarks = {};                    ///< guesses, choices and repairs, as lines for people
};

/// Returns the positions of the body's vertices in the scene, in m, from the positions in its file.
std::vector<sim::Vec3> placed_m(const FileVertexPlaces& places, const std::vector<sim::Vec3>& in_file);

/// Returns the frames of a body that grows into its clothes and then continues with its motion. Vertices move straight,
/// slowly at both ends. The growth begins in the first of `poses`, goes through them in order and ends in the body's
/// pose. Without `poses`, the body grows in its own pose.
std::shared_ptr<const sim::BodyFrames> make_growing_frames(const Wearer& wearer, std::span<const RigPose> poses = {});

/// A bone that is turned about its first joint.
struct TurnedBone {
  sim::Index joint = 0;
  sim::Index end = 0;               ///< joint at its end
  sim::Vec3 direction = {0, 0, 0};  ///< target direction, of any length, in the file's axes
};

using LimbParts = std::array<const char*, 3>;
inline constexpr LimbParts arm_parts = {"arm", "forearm", "hand"}, leg_parts = {"upleg", "leg", "foot"};

/// A limb in the pose in which the run begins.
struct Limb {
  std::vector<sim::Index> joints;       ///< joints in their order from the trunk outwards
  sim::Vec3 begin_m = {0.0, 0.0, 0.0};  ///< position of the first joint
};

/// Returns a limb on the side of positive x, the left one, or on the other side. Empty if the body has fewer than two
/// of its joints.
std::optional<Limb> find_limb(const Wearer& wearer, double side, const LimbParts& parts);

/// Adds the bones of a limb, turned to this direction of the scene.
void turn_limb(const Wearer& wearer, const Limb& limb, const sim::Vec3& direction, std::vector<TurnedBone>& bones);

/// Returns poses in which bones turn, with all nodes below them, from their target directions to this pose, which is
/// left out. Requires each bone before the bones below it.
std::vector<RigPose> make_turning_poses(const Rig& rig, const RigPose& pose, std::span<const TurnedBone> bones);

/// Returns poses between the stored pose of the body and the pose in which the run begins, which is left out.
std::vector<RigPose> make_poses_from_stored(const Wearer& wearer);

/// A body that is thinner where it would touch itself.
struct ClearanceResult {
  Rig rig;
  std::size_t vertices = 0;     ///< count of vertices that were moved
  double max_distance_m = 0.0;  ///< largest distance by which a vertex was moved
};

/// Leaves clearance for cloth where parts of a body close in on each other in one of these poses, as arms do at the
/// armpits and legs at the crotch. As the body grows from its bones, a vertex stops where another surface comes near
/// before it, and stays that much nearer to its bones in all poses. Within heads, hands and feet no clearance is left.
/// `garments` is the number of garments worn over each other. Returns nothing if no surfaces come near each other. The
/// triangles connect the vertices that `places` maps to the file.
std::optional<ClearanceResult> leave_clearance(const Rig& rig, std::span<const RigPose> poses,
                                               const FileVertexPlaces& places, std::span<const sim::Triangle> triangles,
                                               int garments);

/// Returns joints for a body that has none, such as a scan: from the hips to the neck and the head, to the hands and to
/// the feet, guessed from its shape. Each vertex follows the nearest bone; vertices of the trunk follow no bone of the
/// arms. The joints are good enough for growth, but not for motion. Positions are in m, with y up, as measured. Returns
/// nothing if the shape has not a neck and two arms.
std::optional<Rig> guess_rig(const sim::Surface& body, const BodyMeasures& measures);

/// Measures a body with its arms. A body without joints is measured with those guessed from its shape.
BodyMeasures measure_body_and_arms(const sim::Surface& body, const JointPlaces& joints);

}  // namespace taut::app
