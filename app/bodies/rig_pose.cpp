#include "app/bodies/rig_pose.hpp"

#include <fmt/core.h>

#include <cctype>
#include <glm/gtc/quaternion.hpp>

namespace taut::app {
namespace {

/// Names of parts in the middle of the body.
constexpr std::array<std::pair<std::string_view, std::string_view>, 20> middle_parts = {{
    {"hip", "hips"},          {"hips", "hips"},     {"pelvis", "hips"},     {"spine", "spine"},   {"spine0", "spine"},
    {"spine01", "spine"},     {"abdomen", "spine"}, {"torso", "spine"},     {"waist", "spine"},   {"spine1", "spine1"},
    {"spine02", "spine1"},    {"chest", "spine1"},  {"abdomen2", "spine1"}, {"spine2", "spine2"}, {"spine03", "spine2"},
    {"upperchest", "spine2"}, {"neck", "neck"},     {"neck01", "neck"},     {"neck1", "neck"},    {"head", "head"},
}};

/// Names of parts on both sides of the body.
constexpr std::array<std::pair<std::string_view, std::string_view>, 34> side_parts = {{
    {"shoulder", "shoulder"}, {"collar", "shoulder"}, {"clavicle", "shoulder"}, {"collarbone", "shoulder"},
    {"arm", "arm"},           {"uparm", "arm"},       {"upperarm", "arm"},      {"shldr", "arm"},
    {"forearm", "forearm"},   {"lowarm", "forearm"},  {"lowerarm", "forearm"},  {"elbow", "forearm"},
    {"hand", "hand"},         {"wrist", "hand"},      {"upleg", "upleg"},       {"thigh", "upleg"},
    {"upperleg", "upleg"},    {"hip", "upleg"},       {"leg", "leg"},           {"shin", "leg"},
    {"calf", "leg"},          {"lowleg", "leg"},      {"lowerleg", "leg"},      {"knee", "leg"},
    {"foot", "foot"},         {"ankle", "foot"},      {"toebase", "toebase"},   {"toe", "toebase"},
    {"toes", "toebase"},      {"ball", "toebase"},    {"toe0", "toebase"},      {"toe1", "toebase"},
    {"butt", "butt"},         {"buttock", "butt"},
}};

constexpr std::array<std::string_view, 10> main_parts = {"hips", "spine", "spine1", "arm",  "forearm",
                                                         "hand", "upleg", "leg",    "foot", "head"};

/// Prefixes of joint names. Blender puts the name of the armature before the names of joints in Collada; by default it
/// is "Armature".
constexpr std::array<std::string_view, 5> prefixes = {"armature", "mixamorig", "bip", "def", "ccbase"};

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Splits "mixamorig:LeftUpLeg" into "left", "up", "leg"; "RShin" into "r", "shin"; "thigh.L" into "thigh", "l".
std::vector<std::string> split_words(std::string_view name) {
  const std::size_t space = name.find_last_of(":|");
  name.remove_prefix(space == std::string_view::npos ? 0 : space + 1);
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool is_word = std::isalnum(static_cast<unsigned char>(c)) != 0;
    const bool starts =
        is_upper(c) && i > 0 &&
        (is_lower(name[i - 1]) || is_digit(name[i - 1]) || (i + 1 < name.size() && is_lower(name[i + 1])));
    if ((!is_word || starts) && !words.back().empty()) words.emplace_back();
    if (is_word) words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  std::erase(words, "");
  return words;
}

/// A joint's name without its side, and the side.
struct SidedName {
  std::string side;  ///< "left ", "right " or empty
  std::string rest;
};

bool take_prefix(std::string& text, std::string_view prefix) {
  const bool has = text.starts_with(prefix);
  text.erase(0, has ? prefix.size() : 0);
  return has;
}

SidedName taken_apart(std::string_view name) {
  SidedName joint;
  for (const std::string& word : split_words(name)) {
    const bool is_left = word == "left" || word == "l";
    if (joint.side.empty() && (is_left || word == "right" || word == "r")) {
      joint.side = is_left ? "left " : "right ";
    } else {
      joint.rest += word;
    }
  }
  for (const std::string_view prefix : prefixes) {
    const std::string whole = joint.rest;
    if (take_prefix(joint.rest, prefix)) joint.rest.erase(0, joint.rest.find_first_not_of("0123456789"));
    joint.rest = joint.rest.empty() ? whole : joint.rest;
  }
  if (joint.side.empty() && take_prefix(joint.rest, "left")) {
    joint.side = "left ";
  } else if (joint.side.empty() && take_prefix(joint.rest, "right")) {
    joint.side = "right ";
  }
  return joint;
}

template <class Table> std::string_view look_up(const Table& table, const std::string& name) {
  const auto found = std::ranges::find_if(table, [&](const auto& row) { return row.first == name; });
  return found == table.end() ? std::string_view(name) : found->second;
}

/// Translation, rotation (x, y, z, w) and scale whose product is a node's transform.
struct NodeMotion {
  sim::Vec3 translation;
  glm::dvec4 rotation;
  sim::Vec3 scale;
};

glm::dmat3 to_matrix(const glm::dvec4& rotation) {
  return glm::mat3_cast(glm::dquat(rotation.w, rotation.x, rotation.y, rotation.z));
}

NodeMotion to_node_motion(const glm::dmat4& transform) {
  glm::dmat3 axes(transform);
  sim::Vec3 scale(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
  if (glm::determinant(axes) < 0.0) scale.x = -scale.x;
  for (int axis = 0; axis < 3; ++axis) {
    axes[axis] = scale[axis] != 0.0 ? axes[axis] / scale[axis] : axes[axis];
  }
  const glm::dquat q = glm::quat_cast(axes);
  return {sim::Vec3(transform[3]), {q.x, q.y, q.z, q.w}, scale};
}

glm::dmat4 to_transform(const NodeMotion& motion) {
  glm::dmat3 axes = to_matrix(motion.rotation);
  for (int axis = 0; axis < 3; ++axis) axes[axis] *= motion.scale[axis];
  glm::dmat4 transform(axes);
  transform[3] = glm::dvec4(motion.translation, 1.0);
  return transform;
}

/// The keys around a time, and the fraction of the way from the first of them to the second.
struct BetweenKeys {
  std::size_t before = 0;
  std::size_t after = 0;
  double share = 0.0;
};

BetweenKeys keys_around(const std::vector<double>& times_s, double time_s) {
  const auto next = std::upper_bound(times_s.begin(), times_s.end(), time_s);
  const auto after = static_cast<std::size_t>(next - times_s.begin());
  if (after == 0) return {};
  if (after == times_s.size()) return {after - 1, after - 1, 0.0};
  return {after - 1, after, (time_s - times_s[after - 1]) / (times_s[after] - times_s[after - 1])};
}

glm::dvec4 straight_at(const RigKeys& keys, double time_s) {
  const BetweenKeys at = keys_around(keys.times_s, time_s);
  return glm::mix(keys.values[at.before], keys.values[at.after], at.share);
}

glm::dvec4 rotation_at(const RigKeys& keys, double time_s) {
  const BetweenKeys at = keys_around(keys.times_s, time_s);
  return rotation_between(glm::normalize(keys.values[at.before]), glm::normalize(keys.values[at.after]), at.share);
}

glm::dmat4 transform_at(const RigNode& node, const RigChannel& channel, double time_s) {
  NodeMotion motion = to_node_motion(node.to_parent);
  if (!channel.positions.times_s.empty()) {
    motion.translation = sim::Vec3(straight_at(channel.positions, time_s));
  }
  if (!channel.rotations.times_s.empty()) motion.rotation = rotation_at(channel.rotations, time_s);
  if (!channel.scales.times_s.empty()) motion.scale = sim::Vec3(straight_at(channel.scales, time_s));
  return to_transform(motion);
}

/// Returns the stored pose, with the transform of each node relative to the node above it.
RigPose stored_in_parents(const Rig& rig) {
  RigPose pose;
  for (const RigNode& node : rig.nodes) pose.to_model.push_back(node.to_parent);
  for (const RigTarget& target : rig.targets) pose.target_weights.push_back(target.weight);
  return pose;
}

// Requires each node after those above it.
void multiply_down(const Rig& rig, std::vector<glm::dmat4>& transforms) {
  for (std::size_t n = 0; n < rig.nodes.size(); ++n) {
    if (rig.nodes[n].parent != no_node) transforms[n] = transforms[rig.nodes[n].parent] * transforms[n];
  }
}

std::vector<sim::Vec3> mixed_in_part(const Rig& rig, const std::vector<double>& weights) {
  std::vector<sim::Vec3> mixed = rig.in_part;
  for (std::size_t t = 0; t < rig.targets.size(); ++t) {
    const RigTarget& target = rig.targets[t];
    const std::size_t first = rig.parts[target.part].first_vertex;
    for (std::size_t v = 0; weights[t] != 0.0 && v < target.offsets.size(); ++v) {
      mixed[first + v] += weights[t] * target.offsets[v];
    }
  }
  return mixed;
}

sim::Vec3 transform_point(const glm::dmat4& transform, const sim::Vec3& point) {
  return sim::Vec3(transform * glm::dvec4(point, 1.0));
}

}  // namespace

std::vector<std::string> parts_of_joints(std::span<const std::string> names) {
  std::vector<SidedName> joints;
  for (const std::string& name : names) joints.push_back(taken_apart(name));
  const bool has_elbows = std::ranges::any_of(joints, [](const SidedName& joint) { return joint.rest == "elbow"; });
  std::vector<std::string> parts;
  for (const SidedName& joint : joints) {
    const bool is_arm = has_elbows && joint.rest == "shoulder";
    const std::string_view part = joint.side.empty() ? look_up(middle_parts, joint.rest)
                                  : is_arm           ? "arm"
                                                     : look_up(side_parts, joint.rest);
    parts.push_back(joint.side + std::string(part));
  }
  return parts;
}

bool is_main_part(const std::string& part) {
  const std::string name = part.substr(part.find(' ') + 1);
  return std::ranges::find(main_parts, name) != main_parts.end();
}

glm::dvec4 rotation_between(const glm::dvec4& from, glm::dvec4 to, double share) {
  // A chord differs from its arc in the last bit alone after this many halvings.
  constexpr int halvings = 20;
  if (glm::dot(from, to) < 0.0) {
    to = -to;  // the same rotation, nearer
  }
  if (share <= 0.0 || from == to) return from;
  glm::dvec4 begin = from;
  glm::dvec4 end = to;
  for (int k = 0; k < halvings; ++k) {
    const glm::dvec4 middle = glm::normalize(begin + end);
    share *= 2.0;
    if (share < 1.0) {
      end = middle;
    } else {
      begin = middle;
      share -= 1.0;
    }
  }
  return glm::normalize(glm::mix(begin, end, share));
}

RigPose stored_pose(const Rig& rig) {
  RigPose pose = stored_in_parents(rig);
  multiply_down(rig, pose.to_model);
  return pose;
}

RigPose pose_at(const Rig& rig, const RigClip& clip, double time_s) {
  RigPose pose = stored_in_parents(rig);
  for (const RigChannel& channel : clip.channels) {
    pose.to_model[channel.node] = transform_at(rig.nodes[channel.node], channel, time_s);
  }
  for (const RigTargetChannel& channel : clip.targets) {
    if (!channel.weights.times_s.empty()) {
      pose.target_weights[channel.target] = straight_at(channel.weights, time_s).x;
    }
  }
  multiply_down(rig, pose.to_model);
  return pose;
}

RigPose pose_between(const Rig& rig, const RigPose& from, const RigPose& to, double share) {
  RigPose pose = from;
  for (sim::Index n = 0; n < rig.nodes.size(); ++n) {
    const auto under_parent = [&](const RigPose& whole) {
      const sim::Index parent = rig.nodes[n].parent;
      return to_node_motion(parent == no_node ? whole.to_model[n]
                                              : glm::inverse(whole.to_model[parent]) * whole.to_model[n]);
    };
    const NodeMotion a = under_parent(from);
    const NodeMotion b = under_parent(to);
    pose.to_model[n] =
        to_transform({glm::mix(a.translation, b.translation, share), rotation_between(a.rotation, b.rotation, share),
                      glm::mix(a.scale, b.scale, share)});
  }
  multiply_down(rig, pose.to_model);
  for (std::size_t t = 0; t < pose.target_weights.size(); ++t) {
    pose.target_weights[t] = glm::mix(from.target_weights[t], to.target_weights[t], share);
  }
  return pose;
}

void pose_vertices(const Rig& rig, const RigPose& pose, std::span<sim::Vec3> positions) {
  const std::vector<sim::Vec3> mixed = mixed_in_part(rig, pose.target_weights);
  for (const RigPart& part : rig.parts) {
    for (std::size_t v = part.first_vertex; v < part.first_vertex + part.vertices; ++v) {
      positions[v] = part.is_skinned ? sim::Vec3(0.0) : transform_point(pose.to_model[part.node], mixed[v]);
    }
  }
  std::vector<glm::dmat4> joints;
  for (const RigBone& bone : rig.bones) joints.push_back(pose.to_model[bone.node] * bone.from_mesh);
  for (const RigInfluence& influence : rig.influences) {
    positions[influence.vertex] += influence.weight * transform_point(joints[influence.bone], mixed[influence.vertex]);
  }
}

std::vector<sim::Vec3> posed_vertices(const Rig& rig, const RigPose& pose) {
  std::vector<sim::Vec3> positions(rig.in_part.size());
  pose_vertices(rig, pose, positions);
  return positions;
}

void require_weights(Rig& rig) {
  std::vector<double> sums(rig.in_part.size(), 0.0);
  for (const RigInfluence& influence : rig.influences) sums[influence.vertex] += influence.weight;
  for (const RigPart& part : rig.parts) {
    for (std::size_t v = part.first_vertex; part.is_skinned && v < part.first_vertex + part.vertices; ++v) {
      if (!(std::abs(sums[v] - 1.0) <= weight_tolerance)) {
        throw std::invalid_argument(
            fmt::format("vertex {} of its mesh '{}': found weights of its joints that sum to {:.6g}, "
                        "expected 1; in glTF, write them as FLOAT and at most four a vertex",
                        v - part.first_vertex, part.mesh, sums[v]));
      }
    }
  }
  for (RigInfluence& influence : rig.influences) influence.weight /= sums[influence.vertex];
}

}  // namespace taut::app
