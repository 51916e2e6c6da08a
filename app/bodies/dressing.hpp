#pragma once

#include "app/bodies/body_girths.hpp"
#include "app/bodies/frame_source.hpp"

namespace taut::app {

/// Returns a body that is thin: each vertex of the pose is moved most of the way to the nearest points of the
/// bones it follows, weighted as it follows them. A bone goes from a joint to each joint below it that
/// vertices follow; without one it is the joint itself. In the file's unit and axes, per vertex of the rig.
/// Throws InputError if vertices follow no joint.
std::vector<sim::Vec3> thin_shape(const Rig& rig, const RigPose& pose);

/// A body that is to be dressed, as load_bodies() keeps it.
struct Wearer {
  std::shared_ptr<const Rig> rig;
  FileVertexPlaces places;
  RigPose pose;                                        ///< with which the run begins
  std::vector<sim::Vec3> full_m;                       ///< where its vertices are then
  std::shared_ptr<const sim::BodyFrames> motion = {};  ///< from then on; null: it stays
  double rate_hz = 60.0;                               ///< of the motion
  double duration_s = 0.0;                             ///< of the growth, before 0 s
  BodyMeasures measures = {};                          ///< as it was stored
  JointPlaces stored_joints = {};                      ///< likewise
  JointPlaces joints = {};                             ///< in the pose
  std::shared_ptr<const sim::BodyFrames> frames = {};  ///< its growth in the pose, then the motion
};

/// Returns where the vertices of a body are that are here in its file.
std::vector<sim::Vec3> placed_m(const FileVertexPlaces& places, const std::vector<sim::Vec3>& in_file);

/// Returns the frames of a body that grows into what it wears and then goes on with its motion. Vertices go
/// straight, slowly at both ends. It begins in the first of `poses`, goes through them one after the other as
/// it grows, and ends in its own; without any it grows in its own.
std::shared_ptr<const sim::BodyFrames> growing(const Wearer& wearer, std::span<const RigPose> poses = {});

/// A bone that is turned about the joint at its begin.
struct TurnedBone {
  sim::Index joint = 0;
  sim::Index end = 0;               ///< the joint at its end
  sim::Vec3 direction = {0, 0, 0};  ///< where it shall point, of any length, in the file's axes
};

/// Returns the joints of a limb, by the parts that they move, without the side: "left " or "right "; none if the body
/// has fewer than two.
std::vector<sim::Index> joints_of_limb(const Rig& rig, const std::string& side,
                                       const std::array<const char*, 3>& parts);

/// Returns a direction of the scene in the axes of the file that was placed so, of another length.
sim::Vec3 in_file_axes(const Placement& placement, const sim::Vec3& direction);

/// Returns poses in which bones turn, with all that hangs on them, from where they shall point to where they
/// are in this pose, which is left out. Requires each bone before those that hang on it.
std::vector<RigPose> turning_back(const Rig& rig, const RigPose& pose, std::span<const TurnedBone> bones);

/// Returns poses on the way from the one in which the body was stored to that in which the run begins, which is left
/// out.
std::vector<RigPose> poses_from_stored(const Wearer& wearer);

/// A body that stays thinner where it would touch itself.
struct RoomForCloth {
  Rig rig;
  std::size_t vertices = 0;  ///< that are held back
  double most_m = 0.0;       ///< the furthest, from where it would be
};

/// Leaves room for cloth where parts of a body close in on each other in one of these poses, as arms do at the
/// armpits and legs at the crotch. As the body grows from its bones, a vertex stops where another surface comes
/// near before it; it stays so much nearer to its bones in all poses. Heads, hands and feet leave none within
/// themselves. So many garments are worn over each other. Empty if nothing comes near. The triangles are those of the
/// mesh whose vertices `places` finds in the file.
std::optional<RoomForCloth> leave_room(const Rig& rig, std::span<const RigPose> poses, const FileVertexPlaces& places,
                                       std::span<const sim::Triangle> triangles, int garments);

/// Returns joints for a body that has none, such as a scan: from the hips to the neck and the head, to the
/// hands and to the feet, where its shape says that they are; each vertex follows the bone that is nearest,
/// along the trunk none of the arms. Good enough to grow from, not to be moved by. Positions are in m, with y
/// up, as they were measured. Empty if the shape is not that of someone with a neck and two arms.
std::optional<Rig> rig_by_shape(const Surface& body, const BodyMeasures& measures);

/// Measures a body with its arms, whose joints are those that its shape shows where it has none.
BodyMeasures measures_of(const Surface& body, const JointPlaces& joints);

}  // namespace taut::app
