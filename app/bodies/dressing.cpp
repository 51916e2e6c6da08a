#include "app/bodies/dressing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <utility>

#include "app/base/errors.hpp"

namespace taut::app {
namespace {

/// The share of the way to the bones. Not all of it: triangles keep an area.
constexpr double thinness = 0.9;
/// The share of its frames in which a body grows. In the rest cloth slides to where it has room.
constexpr double ends_at = 0.8;
/// Poses that a turn goes through. Between two of them vertices go straight.
constexpr int turning_steps = 8;

/// Per node, whether vertices follow it.
std::vector<bool> followed(const Rig& rig) {
  std::vector<bool> is_followed(rig.nodes.size(), false);
  for (const RigInfluence& influence : rig.influences) {
    is_followed[rig.bones[influence.bone].node] = true;
  }
  return is_followed;
}

/// The node or the nearest above it that vertices follow; no_node if there is none.
sim::Index joint_at(sim::Index node, const Rig& rig, const std::vector<bool>& is_followed) {
  while (node != no_node && !is_followed[node]) {
    node = rig.nodes[node].parent;
  }
  return node;
}

sim::Vec3 place_of(const RigPose& pose, sim::Index node) {
  return sim::Vec3(pose.to_model[node][3]);
}

/// Per node, the far ends of its bones.
std::vector<std::vector<sim::Vec3>> ends_of_bones(const Rig& rig, const RigPose& pose,
                                                  const std::vector<bool>& is_followed) {
  std::vector<std::vector<sim::Vec3>> ends(rig.nodes.size());
  for (sim::Index n = 0; n < rig.nodes.size(); ++n) {
    const sim::Index above = is_followed[n] ? joint_at(rig.nodes[n].parent, rig, is_followed) : no_node;
    if (above != no_node) {
      ends[above].push_back(place_of(pose, n));
    }
  }
  return ends;
}

sim::Vec3 nearest_on_bones(const sim::Vec3& begin, const std::vector<sim::Vec3>& ends,
                           const sim::Vec3& point) {
  sim::Vec3 nearest = begin;
  for (const sim::Vec3& end : ends) {
    const sim::Vec3 along = end - begin;
    const double squared = glm::dot(along, along);
    const double share = squared > 0.0 ? std::clamp(glm::dot(point - begin, along) / squared, 0.0, 1.0) : 0.0;
    const sim::Vec3 candidate = begin + share * along;
    if (glm::distance(candidate, point) < glm::distance(nearest, point)) {
      nearest = candidate;
    }
  }
  return nearest;
}

/// A body in one of the poses that it grows through.
struct Grown {
  std::vector<sim::Vec3> thin_m;
  std::vector<sim::Vec3> full_m;
};

class GrowingFrames final : public sim::BodyFrames {
 public:
  GrowingFrames(std::vector<Grown> shapes, const Wearer& wearer)
      : shapes_(std::move(shapes)),
        motion_(wearer.motion),
        rate_hz_(wearer.rate_hz),
        frames_(static_cast<std::size_t>(std::ceil(wearer.duration_s * wearer.rate_hz))) {}

  std::size_t count() const override { return frames_ + (motion_ ? motion_->count() : 1); }
  double rate_hz() const override { return rate_hz_; }
  double first_s() const override { return -static_cast<double>(frames_) / rate_hz_; }

  void positions_in(std::size_t frame, std::span<sim::Vec3> positions_m) const override {
    if (frame >= frames_ && motion_) {
      motion_->positions_in(frame - frames_, positions_m);
      return;
    }
    const double share = static_cast<double>(frame) / (ends_at * static_cast<double>(std::max<std::size_t>(frames_, 1)));
    const double grown = share >= 1.0 ? 1.0 : share * share * (3.0 - 2.0 * share);
    const double at = grown * static_cast<double>(shapes_.size() - 1);
    const auto before = static_cast<std::size_t>(at);
    const Grown& a = shapes_[before];
    const Grown& b = shapes_[std::min(before + 1, shapes_.size() - 1)];
    const double on = at - static_cast<double>(before);
    for (std::size_t v = 0; v < positions_m.size(); ++v) {
      positions_m[v] = glm::mix(on > 0.0 ? glm::mix(a.thin_m[v], b.thin_m[v], on) : a.thin_m[v],
                                on > 0.0 ? glm::mix(a.full_m[v], b.full_m[v], on) : a.full_m[v], grown);
    }
  }

 private:
  std::vector<Grown> shapes_;  ///< at equal shares of the growth
  std::shared_ptr<const sim::BodyFrames> motion_;
  double rate_hz_;
  std::size_t frames_;  ///< of the growth
};

/// The rotation along the shorter arc that takes one direction to another, as x, y, z, w.
glm::dvec4 rotation_from_to(const sim::Vec3& from, const sim::Vec3& to) {
  const sim::Vec3 a = glm::normalize(from);
  const sim::Vec3 b = glm::normalize(to);
  const glm::dvec4 rotation(glm::cross(a, b), 1.0 + glm::dot(a, b));
  // Where they are opposite any axis will do.
  return glm::dot(rotation, rotation) > 1e-12 ? glm::normalize(rotation) : glm::dvec4(1.0, 0.0, 0.0, 0.0);
}

/// Turns a node and all that hangs on it about its place.
void turn_about(const Rig& rig, sim::Index joint, const glm::dvec4& rotation, RigPose& pose) {
  const sim::Vec3 place = place_of(pose, joint);
  const glm::dquat q(rotation.w, rotation.x, rotation.y, rotation.z);
  const glm::dmat4 turn =
      glm::translate(glm::dmat4(1.0), place) * glm::mat4_cast(q) * glm::translate(glm::dmat4(1.0), -place);
  std::vector<bool> is_turned(rig.nodes.size(), false);
  for (sim::Index n = joint; n < rig.nodes.size(); ++n) {
    const sim::Index parent = rig.nodes[n].parent;
    is_turned[n] = n == joint || (parent != no_node && is_turned[parent]);
    pose.to_model[n] = is_turned[n] ? turn * pose.to_model[n] : pose.to_model[n];
  }
}

}  // namespace

std::vector<sim::Vec3> thin_shape(const Rig& rig, const RigPose& pose) {
  const std::vector<bool> is_followed = followed(rig);
  const std::vector<std::vector<sim::Vec3>> ends = ends_of_bones(rig, pose, is_followed);
  std::vector<sim::Vec3> full(rig.in_part.size());
  pose_vertices(rig, pose, full);
  std::vector<sim::Vec3> on_bones(full.size(), sim::Vec3(0.0));
  for (const RigPart& part : rig.parts) {
    const sim::Index joint = joint_at(part.node, rig, is_followed);
    if (!part.is_skinned && part.vertices > 0 && joint == no_node) {
      throw InputError("found a body to be dressed whose mesh '" + part.mesh +
                       "' follows no joint; expected a skin, as glTF, FBX and Collada may have");
    }
    for (std::size_t v = part.first_vertex; !part.is_skinned && v < part.first_vertex + part.vertices; ++v) {
      on_bones[v] = nearest_on_bones(place_of(pose, joint), ends[joint], full[v]);
    }
  }
  for (const RigInfluence& influence : rig.influences) {
    const sim::Index node = rig.bones[influence.bone].node;
    on_bones[influence.vertex] +=
        influence.weight * nearest_on_bones(place_of(pose, node), ends[node], full[influence.vertex]);
  }
  for (std::size_t v = 0; v < full.size(); ++v) {
    full[v] = glm::mix(full[v], on_bones[v], thinness);
  }
  return full;
}

std::vector<sim::Vec3> placed_m(const FileVertexPlaces& places, const std::vector<sim::Vec3>& in_file) {
  std::vector<sim::Vec3> result_m;
  for (const std::size_t v : places.file_vertex) {
    result_m.push_back(places.placement(in_file[v]));
  }
  return result_m;
}

std::shared_ptr<const sim::BodyFrames> growing(const Wearer& wearer, std::span<const RigPose> poses) {
  std::vector<Grown> shapes;
  std::vector<sim::Vec3> full(wearer.rig->in_part.size());
  for (const RigPose& pose : poses) {
    pose_vertices(*wearer.rig, pose, full);
    shapes.push_back({placed_m(wearer.places, thin_shape(*wearer.rig, pose)), placed_m(wearer.places, full)});
  }
  shapes.push_back({placed_m(wearer.places, thin_shape(*wearer.rig, wearer.pose)), wearer.full_m});
  return std::make_shared<const GrowingFrames>(std::move(shapes), wearer);
}

sim::Vec3 in_file_axes(const Placement& placement, const sim::Vec3& direction) {
  const sim::Vec3 origin = placement(sim::Vec3(0.0));
  sim::Vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    sim::Vec3 unit(0.0);
    unit[axis] = 1.0;
    result[axis] = glm::dot(placement(unit) - origin, direction);
  }
  return result;
}

std::vector<RigPose> turning_back(const Rig& rig, const RigPose& pose, std::span<const TurnedBone> bones) {
  constexpr glm::dvec4 as_it_is(0.0, 0.0, 0.0, 1.0);
  RigPose turned = pose;
  std::vector<glm::dvec4> rotations;
  for (const TurnedBone& bone : bones) {
    rotations.push_back(
        rotation_from_to(place_of(turned, bone.end) - place_of(turned, bone.joint), bone.direction));
    turn_about(rig, bone.joint, rotations.back(), turned);
  }
  std::vector<RigPose> poses;
  for (int step = 0; step < turning_steps; ++step) {
    RigPose& here = poses.emplace_back(pose);
    for (std::size_t b = 0; b < bones.size(); ++b) {
      const double share = static_cast<double>(step) / turning_steps;
      turn_about(rig, bones[b].joint, rotation_between(rotations[b], as_it_is, share), here);
    }
  }
  return poses;
}

std::vector<RigPose> poses_from_stored(const Wearer& wearer) {
  std::vector<RigPose> poses;
  for (int step = 0; step < turning_steps; ++step) {
    poses.push_back(pose_between(*wearer.rig, stored_pose(*wearer.rig), wearer.pose,
                                 static_cast<double>(step) / turning_steps));
  }
  return poses;
}

}  // namespace taut::app
