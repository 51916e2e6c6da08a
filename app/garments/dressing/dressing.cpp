#include "app/garments/dressing/dressing.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/garments/dressing/tuning.hpp"
#include "app/garments/fitting/following.hpp"

namespace taut::app {
namespace {

using namespace dressing;

/// Returns, per node, whether vertices follow it.
std::vector<bool> find_followed(const Rig& rig) {
  std::vector<bool> is_followed(rig.nodes.size(), false);
  for (const RigInfluence& influence : rig.influences) is_followed[rig.bones[influence.bone].node] = true;
  return is_followed;
}

/// Returns the nearest node that vertices follow, from this one upwards; no_node if there is none.
sim::Index joint_at(sim::Index node, const Rig& rig, const std::vector<bool>& is_followed) {
  while (node != no_node && !is_followed[node]) node = rig.nodes[node].parent;
  return node;
}

sim::Vec3 node_position(const RigPose& pose, sim::Index node) { return sim::Vec3(pose.to_model[node][3]); }

/// Calls `visit` with each influence on a vertex: the vertex, its node, its weight and the transform to that node.
/// Vertices without a skin follow the node of their part.
template <class Visit> void for_each_influence(const Rig& rig, const Visit& visit) {
  for (const RigPart& part : rig.parts) {
    for (std::size_t v = part.first_vertex; !part.is_skinned && v < part.first_vertex + part.vertices; ++v) {
      visit(v, part.node, 1.0, glm::dmat4(1.0));
    }
  }
  for (const RigInfluence& influence : rig.influences) {
    const RigBone& bone = rig.bones[influence.bone];
    visit(influence.vertex, bone.node, influence.weight, bone.from_mesh);
  }
}

/// Returns, per node, the far ends of its bones.
std::vector<std::vector<sim::Vec3>> find_bone_ends(const Rig& rig, const RigPose& pose,
                                                   const std::vector<bool>& is_followed) {
  std::vector<std::vector<sim::Vec3>> ends(rig.nodes.size());
  for (sim::Index n = 0; n < rig.nodes.size(); ++n) {
    const sim::Index above = is_followed[n] ? joint_at(rig.nodes[n].parent, rig, is_followed) : no_node;
    if (above != no_node) ends[above].push_back(node_position(pose, n));
  }
  return ends;
}

sim::Vec3 find_nearest_bone_point(const sim::Vec3& begin, const std::vector<sim::Vec3>& ends, const sim::Vec3& point) {
  sim::Vec3 closest_point = begin;
  for (const sim::Vec3& end : ends) {
    const sim::Vec3 candidate = begin + share_along(point, begin, end) * (end - begin);
    if (glm::distance(candidate, point) < glm::distance(closest_point, point)) closest_point = candidate;
  }
  return closest_point;
}

/// Thin and full shape of a body in one pose of its growth.
struct GrowthShape {
  std::vector<sim::Vec3> thin_m;
  std::vector<sim::Vec3> full_m;
};

class GrowingFrames final : public sim::BodyFrames {
 public:
  GrowingFrames(std::vector<GrowthShape> shapes, const Wearer& wearer)
      : shapes_(std::move(shapes)),
        motion_(wearer.motion),
        own_m_(wearer.own_m),
        rate_hz_(wearer.rate_hz),
        frames_(static_cast<std::size_t>(std::ceil(wearer.duration_s * wearer.rate_hz))) {}

  std::size_t count() const override {
    return frames_ + (motion_ ? motion_->count() : own_m_.empty() ? 1 : frames_to_own_shape + 1);
  }
  double rate_hz() const override { return rate_hz_; }
  double first_s() const override { return -static_cast<double>(frames_) / rate_hz_; }

  void positions_in(std::size_t frame, std::span<sim::Vec3> positions_m) const override {
    if (frame >= frames_ && motion_) {
      motion_->positions_in(frame - frames_, positions_m);
      return;
    }
    if (frame >= frames_ && !own_m_.empty()) {
      const double share = static_cast<double>(frame - frames_) / frames_to_own_shape;
      const std::vector<sim::Vec3>& full_m = shapes_.back().full_m;
      for (std::size_t v = 0; v < own_m_.size(); ++v) positions_m[v] = glm::mix(full_m[v], own_m_[v], share);
      return;
    }
    const double share =
        static_cast<double>(frame) / (growth_time_fraction * static_cast<double>(std::max<std::size_t>(frames_, 1)));
    const double grown = share >= 1.0 ? 1.0 : share * share * (3.0 - 2.0 * share);
    const double at = grown * static_cast<double>(shapes_.size() - 1);
    const auto before = static_cast<std::size_t>(at);
    const GrowthShape& a = shapes_[before];
    const GrowthShape& b = shapes_[std::min(before + 1, shapes_.size() - 1)];
    const double on = at - static_cast<double>(before);
    for (std::size_t v = 0; v < positions_m.size(); ++v) {
      positions_m[v] = glm::mix(glm::mix(a.thin_m[v], b.thin_m[v], on), glm::mix(a.full_m[v], b.full_m[v], on), grown);
    }
  }

 private:
  std::vector<GrowthShape> shapes_;  ///< shapes at equal fractions of the growth
  std::shared_ptr<const sim::BodyFrames> motion_;
  std::vector<sim::Vec3> own_m_;
  double rate_hz_;
  std::size_t frames_;  ///< count of the growth's frames
};

/// Returns the rotation along the shorter arc from one direction to another, as x, y, z, w.
glm::dvec4 rotation_from_to(const sim::Vec3& from, const sim::Vec3& to) {
  const sim::Vec3 a = glm::normalize(from);
  const sim::Vec3 b = glm::normalize(to);
  const glm::dvec4 rotation(glm::cross(a, b), 1.0 + glm::dot(a, b));
  // Any axis will do for opposite directions.
  return glm::dot(rotation, rotation) > 1e-12 ? glm::normalize(rotation) : glm::dvec4(1.0, 0.0, 0.0, 0.0);
}

/// Turns a node and all nodes below it about its position.
void turn_about(const Rig& rig, sim::Index joint, const glm::dvec4& rotation, RigPose& pose) {
  const sim::Vec3 place = node_position(pose, joint);
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

/// Mark of a vertex at the end of a crease, where surfaces are near each other in the thinnest shape too. It is not
/// moved.
constexpr double crease_mark = 2.0;

/// A body as it grows.
struct Growth {
  std::vector<sim::Vec3> thin_m, full_m;
  std::span<const sim::Triangle> triangles;
  std::span<const sim::Index> ends;  ///< per vertex; see find_body_ends()
  double room_m;

  /// Stops the growth of vertices that are too near to another surface facing them.
  void stop_at(double share, double stopped_share, std::vector<double>& most) const {
    std::vector<sim::Vec3> positions_m = thin_m;
    for (std::size_t v = 0; v < most.size(); ++v) {
      positions_m[v] = glm::mix(thin_m[v], full_m[v], std::min(share, most[v]));
    }
    const std::vector<sim::Vec3> normals = vertex_normals(positions_m, triangles);
    const SurfaceTree tree(positions_m, triangles);
    for (std::size_t v = 0; v < positions_m.size(); ++v) {
      const sim::Vec3& normal = normals[v];
      const auto is_before = [&](const TreeSurfacePoint& point) {
        const sim::Vec3 other = sim::doubled_area_vector(positions_m, triangles[point.triangle]);
        const bool is_in_end = ends[v] != no_node && ends[triangles[point.triangle][0]] == ends[v];
        return !is_in_end && glm::dot(point.place_m - positions_m[v], normal) > 0.0 &&
               glm::dot(other, normal) < max_facing_cosine * glm::length(other) * glm::length(normal);
      };
      if (most[v] > stopped_share && most[v] <= 1.0 && tree.find_nearest(positions_m[v], room_m, is_before)) {
        most[v] = stopped_share > min_kept_growth_fraction ? stopped_share : crease_mark;
      }
    }
  }
};

/// Returns, per vertex of the file, the linear part of the transform from its part's axes to the model's.
std::vector<glm::dmat3> into_model(const Rig& rig, const RigPose& pose) {
  std::vector<glm::dmat3> transforms(rig.in_part.size(), glm::dmat3(0.0));
  for_each_influence(rig, [&](std::size_t v, sim::Index node, double weight, const glm::dmat4& from_mesh) {
    transforms[v] += weight * glm::dmat3(pose.to_model[node] * from_mesh);
  });
  return transforms;
}

/// Returns, per vertex of the file, the end of the body that it follows most: the head with the neck, a hand or a foot,
/// each with the nodes below it. No cloth goes between lips, fingers or toes. The value is no_node elsewhere.
std::vector<sim::Index> find_body_ends(const Rig& rig) {
  std::vector<sim::Index> of_node(rig.nodes.size(), no_node);
  const std::map<std::string, sim::Index> joints = joint_nodes(rig);
  for (const char* end : {"neck", "head", "left hand", "right hand", "left foot", "right foot"}) {
    if (const auto found = joints.find(end); found != joints.end()) of_node[found->second] = found->second;
  }
  for (sim::Index n = 0; n < of_node.size(); ++n) {
    const sim::Index parent = rig.nodes[n].parent;
    of_node[n] = parent != no_node && of_node[parent] != no_node ? of_node[parent] : of_node[n];
  }
  std::vector<sim::Index> ends(rig.in_part.size(), no_node);
  std::vector<double> most(ends.size(), 0.0);
  for_each_influence(rig, [&](std::size_t v, sim::Index node, double weight, const glm::dmat4&) {
    ends[v] = weight > most[v] ? of_node[node] : ends[v];
    most[v] = std::max(most[v], weight);
  });
  return ends;
}

enum class LimbKind { trunk, arm, leg };

struct Bone {
  sim::Index begin = 0;
  sim::Index end = 0;
  LimbKind limb = LimbKind::trunk;
};

template <class Condition>
std::vector<sim::Vec3> select(std::span<const sim::Vec3> points_m, const Condition& is_selected) {
  std::vector<sim::Vec3> selected_m;
  std::ranges::copy_if(points_m, std::back_inserter(selected_m), is_selected);
  return selected_m;
}

class ShapeRigMaker {
 public:
  ShapeRigMaker(const sim::Surface& body, const BodyMeasures& measures)
      : body_(body),
        measures_(measures),
        below_arms_(measures.levels.back()),
        neck_m_(*measures.neck_m),
        box_(sim::compute_extent(body.positions_m)) {}

  std::optional<Rig> make() {
    const LevelTape& fork = measures_.levels[measures_.fork];
    const double half_width_m = below_arms_.half_width_m;
    const sim::Vec3 hips_m =
        fork.middle_m + sim::Vec3(0.0, hips_above_fork_fraction * (below_arms_.height_m - fork.height_m), 0.0);
    const sim::Index hips = add("Hips", no_node, hips_m, LimbKind::trunk);
    const sim::Index neck = add("Neck", hips, neck_m_, LimbKind::trunk);
    add("Head", neck, {neck_m_.x, 0.5 * (neck_m_.y + box_.upper.y), neck_m_.z}, LimbKind::trunk);
    for (const double side : {1.0, -1.0}) {
      const std::string name = side > 0.0 ? "Left" : "Right";
      const sim::Vec3 shoulder_m = glm::mix(below_arms_.middle_m, neck_m_, shoulder_height_fraction) +
                                   sim::Vec3(side * shoulder_offset_fraction * half_width_m, 0.0, 0.0);
      const auto own_m = select(body_.positions_m, [&](const auto& p) { return side * (p.x - neck_m_.x) > 0.0; });
      const auto arm_m = select(own_m, [&](const auto& p) { return is_beside_trunk(p); });
      const auto foot_m =
          select(own_m, [&](const auto& p) { return p.y < box_.lower.y + foot_height_fraction * box_.size().y; });
      if (arm_m.empty() || foot_m.empty()) return std::nullopt;
      const auto from_shoulder_m = [&](const sim::Vec3& p) { return glm::distance(p, shoulder_m); };
      const sim::Vec3 hand_m = *std::ranges::max_element(arm_m, {}, from_shoulder_m);
      const auto elbow_m = select(arm_m, [&](const auto& p) {
        return std::abs(from_shoulder_m(p) / from_shoulder_m(hand_m) - elbow_fraction) < elbow_tolerance;
      });
      const sim::Vec3 middle_m =
          elbow_m.empty() ? glm::mix(shoulder_m, hand_m, elbow_fraction) : sim::compute_extent(elbow_m).middle();
      const sim::Index arm = add(name + "Arm", neck, shoulder_m, LimbKind::arm);
      add(name + "Hand", add(name + "ForeArm", arm, middle_m, LimbKind::arm), hand_m, LimbKind::arm);
      const sim::Vec3 hip_m = hips_m + sim::Vec3(side * hip_offset_fraction * half_width_m, 0.0, 0.0);
      add(name + "Foot", add(name + "UpLeg", hips, hip_m, LimbKind::leg), sim::compute_extent(foot_m).middle(),
          LimbKind::leg);
    }
    follow();
    return std::move(rig_);
  }

 private:
  sim::Index add(const std::string& name, sim::Index parent, const sim::Vec3& place_m, LimbKind limb) {
    const auto node = static_cast<sim::Index>(rig_.nodes.size());
    const sim::Vec3 from_m = parent == no_node ? sim::Vec3(0.0) : places_m_[parent];
    rig_.nodes.push_back({name, parent, glm::translate(glm::dmat4(1.0), place_m - from_m)});
    rig_.bones.push_back({node, glm::translate(glm::dmat4(1.0), -place_m)});
    places_m_.push_back(place_m);
    if (parent != no_node) bones_.push_back({parent, node, limb});
    return node;
  }

  /// Returns whether a point is beside the trunk or the legs. Points above the trunk are compared with its upper end.
  bool is_beside_trunk(const sim::Vec3& p) const {
    if (p.y < measures_.levels[measures_.fork].height_m - hands_below_fork_fraction * box_.size().y) return false;
    const LevelTape& level = measures_.level_at(p.y);
    return std::abs(p.x - level.middle_m.x) > beside_trunk_ratio * level.half_width_m;
  }

  bool may_follow(const sim::Vec3& p, LimbKind limb) const {
    if (p.y > below_arms_.height_m) return limb != LimbKind::leg;
    return is_beside_trunk(p) == (limb == LimbKind::arm);
  }

  void follow() {
    rig_.in_part.assign(body_.positions_m.begin(), body_.positions_m.end());
    rig_.parts = {{0, "", 0, rig_.in_part.size(), true}};
    for (std::size_t v = 0; v < rig_.in_part.size(); ++v) {
      const sim::Vec3& p = rig_.in_part[v];
      double min_distance_m = std::numeric_limits<double>::infinity();
      sim::Index joint = 0;
      for (const Bone& bone : bones_) {
        const sim::Vec3 &begin_m = places_m_[bone.begin], &end_m = places_m_[bone.end];
        const double share = share_along(p, begin_m, end_m);
        const double distance_m = glm::distance(p, begin_m + share * (end_m - begin_m));
        if (may_follow(p, bone.limb) && distance_m < min_distance_m) {
          min_distance_m = distance_m;
          joint = share > end_joint_fraction ? bone.end : bone.begin;
        }
      }
      rig_.influences.push_back({v, joint, 1.0});
    }
  }

  const sim::Surface& body_;
  const BodyMeasures& measures_;
  const LevelTape& below_arms_;
  sim::Vec3 neck_m_;
  sim::Extent box_;
  Rig rig_;
  std::vector<sim::Vec3> places_m_;
  std::vector<Bone> bones_;
};

}  // namespace

std::vector<sim::Vec3> compute_thin_shape(const Rig& rig, const RigPose& pose) {
  const std::vector<bool> is_followed = find_followed(rig);
  const std::vector<std::vector<sim::Vec3>> ends = find_bone_ends(rig, pose, is_followed);
  std::vector<sim::Vec3> full = posed_vertices(rig, pose);
  std::vector<sim::Vec3> on_bones(full.size(), sim::Vec3(0.0));
  for (const RigPart& part : rig.parts) {
    if (!part.is_skinned && part.vertices > 0 && joint_at(part.node, rig, is_followed) == no_node) {
      throw InputError("found a body to be dressed whose mesh '" + part.mesh +
                       "' follows no joint; expected a skin, as glTF, FBX and Collada may have");
    }
  }
  for_each_influence(rig, [&](std::size_t v, sim::Index node, double weight, const glm::dmat4&) {
    const sim::Index joint = joint_at(node, rig, is_followed);
    on_bones[v] += weight * find_nearest_bone_point(node_position(pose, joint), ends[joint], full[v]);
  });
  for (std::size_t v = 0; v < full.size(); ++v) full[v] = glm::mix(full[v], on_bones[v], thinning_fraction);
  return full;
}

std::vector<sim::Vec3> placed_m(const FileVertexPlaces& places, const std::vector<sim::Vec3>& in_file) {
  return collect<sim::Vec3>(places.file_vertex, [&](std::size_t v) { return places.placement(in_file[v]); });
}

std::shared_ptr<const sim::BodyFrames> make_growing_frames(const Wearer& wearer, std::span<const RigPose> poses) {
  std::vector<GrowthShape> shapes;
  for (const RigPose& pose : poses) {
    shapes.push_back({placed_m(wearer.places, compute_thin_shape(*wearer.rig, pose)),
                      placed_m(wearer.places, posed_vertices(*wearer.rig, pose))});
  }
  shapes.push_back({placed_m(wearer.places, compute_thin_shape(*wearer.rig, wearer.pose)), wearer.full_m});
  return std::make_shared<const GrowingFrames>(std::move(shapes), wearer);
}

std::optional<Limb> find_limb(const Wearer& wearer, double side, const LimbParts& parts) {
  const std::map<std::string, sim::Index> nodes = joint_nodes(*wearer.rig);
  Limb limb;
  for (const char* const part : parts) {
    const auto node = nodes.find((side > 0.0 ? "left " : "right ") + std::string(part));
    if (node != nodes.end()) limb.joints.push_back(node->second);
  }
  if (limb.joints.size() < 2) return std::nullopt;
  limb.begin_m = wearer.places.placement(node_position(wearer.pose, limb.joints[0]));
  return limb;
}

void turn_limb(const Wearer& wearer, const Limb& limb, const sim::Vec3& direction, std::vector<TurnedBone>& bones) {
  const Placement& placement = wearer.places.placement;
  sim::Vec3 in_file;
  for (int axis = 0; axis < 3; ++axis) {
    sim::Vec3 unit(0.0);
    unit[axis] = 1.0;
    in_file[axis] = glm::dot(placement(unit) - placement(sim::Vec3(0.0)), direction);
  }
  for (std::size_t k = 1; k < limb.joints.size(); ++k) bones.push_back({limb.joints[k - 1], limb.joints[k], in_file});
}

std::vector<RigPose> make_turning_poses(const Rig& rig, const RigPose& pose, std::span<const TurnedBone> bones) {
  constexpr glm::dvec4 as_it_is(0.0, 0.0, 0.0, 1.0);
  RigPose turned = pose;
  std::vector<glm::dvec4> rotations;
  for (const TurnedBone& bone : bones) {
    rotations.push_back(
        rotation_from_to(node_position(turned, bone.end) - node_position(turned, bone.joint), bone.direction));
    turn_about(rig, bone.joint, rotations.back(), turned);
  }
  std::vector<RigPose> poses;
  for (int step = 0; step < turn_pose_count; ++step) {
    RigPose& here = poses.emplace_back(pose);
    for (std::size_t b = 0; b < bones.size(); ++b) {
      const double share = static_cast<double>(step) / turn_pose_count;
      turn_about(rig, bones[b].joint, rotation_between(rotations[b], as_it_is, share), here);
    }
  }
  return poses;
}

std::vector<RigPose> make_poses_from_stored(const Wearer& wearer) {
  std::vector<RigPose> poses;
  for (int step = 0; step < turn_pose_count; ++step) {
    poses.push_back(
        pose_between(*wearer.rig, stored_pose(*wearer.rig), wearer.pose, static_cast<double>(step) / turn_pose_count));
  }
  return poses;
}

std::optional<ClearanceResult> leave_clearance(const Rig& rig, std::span<const RigPose> poses,
                                               const FileVertexPlaces& places, std::span<const sim::Triangle> triangles,
                                               int garments) {
  std::vector<double> most(places.file_vertex.size(), 1.0);
  const std::vector<sim::Index> ends_in_file = find_body_ends(rig);
  const auto ends = collect<sim::Index>(places.file_vertex, [&](std::size_t v) { return ends_in_file[v]; });
  for (const RigPose& pose : poses) {
    const Growth growth = {placed_m(places, compute_thin_shape(rig, pose)), placed_m(places, posed_vertices(rig, pose)),
                           triangles, ends, first_garment_clearance_m + (garments - 1) * further_garment_clearance_m};
    for (int step = 1; step <= growth_step_count; ++step) {
      throw_if_interrupted();
      const auto share_at = [](int s) {
        return min_kept_growth_fraction + (1.0 - min_kept_growth_fraction) * s / growth_step_count;
      };
      growth.stop_at(share_at(step), share_at(step - 1), most);
    }
  }
  const RigPose& pose = poses.front();
  const std::vector<glm::dmat3> transforms = into_model(rig, pose);
  const std::vector<sim::Vec3> thin = compute_thin_shape(rig, pose);
  const std::vector<sim::Vec3> full = posed_vertices(rig, pose);
  ClearanceResult result{rig};
  for (std::size_t v = 0; v < most.size(); ++v) {
    const std::size_t in_file = places.file_vertex[v];
    const sim::Vec3 back = (1.0 - most[v]) * (thin[in_file] - full[in_file]);
    if (most[v] < 1.0) {
      ++result.vertices;
      result.rig.in_part[in_file] += glm::inverse(transforms[in_file]) * back;
      result.max_distance_m = std::max(result.max_distance_m, glm::distance(places.placement(full[in_file]),
                                                                            places.placement(full[in_file] + back)));
    }
  }
  return result.vertices > 0 ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<Rig> guess_rig(const sim::Surface& body, const BodyMeasures& measures) {
  return measures.levels.empty() || !measures.neck_m ? std::nullopt : ShapeRigMaker(body, measures).make();
}

BodyMeasures measure_body_and_arms(const sim::Surface& body, const JointPlaces& joints) {
  BodyMeasures measures = measure_body(body, joints);
  const std::optional<Rig> guessed = joints.empty() ? guess_rig(body, measures) : std::nullopt;
  measure_arms(body, guessed ? compute_joint_positions(*guessed, stored_pose(*guessed), {}) : joints, measures);
  return measures;
}

}  // namespace taut::app
