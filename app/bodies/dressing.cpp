#include "app/bodies/dressing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "app/base/errors.hpp"

namespace taut::app {
namespace {

/// The share of the way to the bones. Not all of it: triangles keep an area.
constexpr double thinness = 0.9;

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

class GrowingFrames final : public sim::BodyFrames {
 public:
  GrowingFrames(Growth growth, std::shared_ptr<const sim::BodyFrames> motion, double rate_hz)
      : growth_(std::move(growth)),
        motion_(std::move(motion)),
        rate_hz_(rate_hz),
        frames_(static_cast<std::size_t>(std::ceil(growth_.duration_s * rate_hz))) {}

  std::size_t count() const override { return frames_ + (motion_ ? motion_->count() : 1); }
  double rate_hz() const override { return rate_hz_; }
  double first_s() const override { return -static_cast<double>(frames_) / rate_hz_; }

  void positions_in(std::size_t frame, std::span<sim::Vec3> positions_m) const override {
    if (frame >= frames_ && motion_) {
      motion_->positions_in(frame - frames_, positions_m);
      return;
    }
    const double share = static_cast<double>(frame) / static_cast<double>(std::max<std::size_t>(frames_, 1));
    const double grown = frame >= frames_ ? 1.0 : share * share * (3.0 - 2.0 * share);
    for (std::size_t v = 0; v < positions_m.size(); ++v) {
      positions_m[v] = glm::mix(growth_.thin_m[v], growth_.full_m[v], grown);
    }
  }

 private:
  Growth growth_;
  std::shared_ptr<const sim::BodyFrames> motion_;
  double rate_hz_;
  std::size_t frames_;  ///< of the growth
};

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

std::shared_ptr<const sim::BodyFrames> with_growth(Growth growth,
                                                   std::shared_ptr<const sim::BodyFrames> motion,
                                                   double rate_hz) {
  return std::make_shared<const GrowingFrames>(std::move(growth), std::move(motion), rate_hz);
}

}  // namespace taut::app
