#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/bodies/frame_source.hpp"
#include "sim/mesh/elementary.hpp"

namespace taut::app {
namespace {

constexpr std::array<std::string_view, 6> channel_names = {"Xposition", "Yposition", "Zposition",
                                                           "Xrotation", "Yrotation", "Zrotation"};

constexpr std::size_t max_depth = 200;
constexpr std::size_t max_joints = 10'000;
constexpr std::size_t max_frames = 10'000'000;
constexpr double min_frame_s = 1e-5;
constexpr double max_frame_s = 1e4;
constexpr double max_number = 1e9;  ///< limit of a length in the file's unit, or of an angle in degrees

struct BvhJoint {
  std::string name;                   ///< empty at the end of a limb
  std::size_t parent = 0;             ///< index of a joint before this one; the root's own index for the root
  sim::Vec3 offset = sim::Vec3(0.0);  ///< offset from the joint above, in the file's unit
  std::vector<int> channels;          ///< indices of channel_names in file order; the last one is applied first
  std::size_t first_number = 0;       ///< index of its first number in a frame
};

/// A motion of joints (Biovision hierarchy). In its zero pose nothing is rotated, so that each joint has the axes of
/// the file.
struct BvhMotion {
  std::vector<BvhJoint> joints;  ///< the root is the first
  std::size_t frames = 0;
  double frame_time_s = 0.0;
  std::size_t numbers = 0;     ///< count of numbers in a frame
  std::vector<double> values;  ///< lengths in the file's unit and angles in degrees, by frame and then by joint
};

/// Joints at one moment.
struct BvhPose {
  std::vector<glm::dmat3> rotations;  ///< per joint, relative to the zero pose, in the axes of the file
  std::vector<sim::Vec3> positions;   ///< per joint, in the file's unit
};

class BvhReader {
 public:
  explicit BvhReader(std::string_view text) : text_(text) {}

  BvhMotion read() {
    require("HIERARCHY");
    require("ROOT");
    read_joint(name_until_brace(), 0, 0);
    require("MOTION");
    require("Frames:");
    motion_.frames = whole_number("the number of frames", 1, max_frames);
    require("Frame");
    require("Time:");
    motion_.frame_time_s = number("the time of a frame in seconds");
    if (!(motion_.frame_time_s >= min_frame_s && motion_.frame_time_s <= max_frame_s)) {
      reject(fmt::format("a time of a frame from {:g} to {:g} s", min_frame_s, max_frame_s));
    }
    const std::string what = count_text(motion_.frames, "frame") + " of " + count_text(motion_.numbers, "number");
    while (motion_.values.size() < motion_.frames * motion_.numbers) motion_.values.push_back(number(what));
    if (!next().empty()) reject("the end of the file after " + what);
    return std::move(motion_);
  }

 private:
  void read_joint(std::string name, std::size_t parent, std::size_t depth) {
    if (depth > max_depth) reject(fmt::format("at most {} joints below each other", max_depth));
    const std::size_t joint = motion_.joints.size();
    if (joint == max_joints) reject(fmt::format("at most {} joints", max_joints));
    motion_.joints.push_back({std::move(name), parent, sim::Vec3(0.0), {}, motion_.numbers});
    for (std::string_view word = next(); word != "}"; word = next()) {
      if (word == "OFFSET") {
        for (int axis = 0; axis < 3; ++axis) motion_.joints[joint].offset[axis] = number("three coordinates");
      } else if (word == "CHANNELS") {
        read_channels(joint);
      } else if (word == "JOINT") {
        read_joint(name_until_brace(), joint, depth + 1);
      } else if (word == "End") {
        require("Site");
        require("{");
        read_joint("", joint, depth + 1);
      } else {
        reject("OFFSET, CHANNELS, JOINT, End Site or }");
      }
    }
  }

  void read_channels(std::size_t joint) {
    if (!motion_.joints[joint].channels.empty()) reject("the channels of a joint once");
    const std::size_t count = whole_number("the number of channels", 0, channel_names.size());
    for (std::size_t k = 0; k < count; ++k) {
      const auto* const found = std::ranges::find(channel_names, next());
      if (found == channel_names.end()) reject("a channel, such as Xposition or Zrotation");
      motion_.joints[joint].channels.push_back(static_cast<int>(found - channel_names.begin()));
    }
    motion_.joints[joint].first_number = motion_.numbers;
    motion_.numbers += count;
  }

  std::string_view next() {
    while (at_ < text_.size() && is_blank(text_[at_])) {
      line_ += text_[at_] == '\n' ? 1 : 0;
      ++at_;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    return word_ = text_.substr(begin, at_ - begin);
  }
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

  /// Reads a name, which may contain spaces.
  std::string name_until_brace() {
    std::string name;
    for (std::string_view word = next(); word != "{"; word = next()) {
      if (word.empty()) reject("{");
      name += name.empty() ? "" : " ";
      name += word;
    }
    return name;
  }

  [[noreturn]] void reject(const std::string& expected) const {
    throw InputError("line {}: found {}, expected {}", line_,
                     word_.empty() ? "the end of the file" : '\'' + std::string(word_) + '\'', expected);
  }
  void require(const char* word) {
    if (next() != word) reject(word);
  }
  double number(const std::string& what) {
    next();
    const std::optional<double> value = number_in<double>(word_);
    if (!value || !(std::abs(*value) <= max_number)) reject(what);
    return *value;
  }
  std::size_t whole_number(const char* what, double least, double most) {
    const double value = number(what);
    if (value != std::floor(value) || value < least || value > most) {
      reject(fmt::format("{}, {:g} to {:g}", what, least, most));
    }
    return static_cast<std::size_t>(value);
  }

  std::string_view text_;
  std::string_view word_;
  std::size_t at_ = 0;
  int line_ = 1;
  BvhMotion motion_;
};

glm::dmat3 make_axis_rotation(int axis, double degrees) {
  const double turns = degrees / 360.0;
  const double c = sim::cosine_of_turns(turns);
  const double s = sim::sine_of_turns(turns);
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  glm::dmat3 rotation(1.0);
  rotation[next][next] = rotation[last][last] = c;
  rotation[next][last] = s;
  rotation[last][next] = -s;
  return rotation;
}

/// Returns the joints in a frame; without a frame, the zero pose with the root at its offset. Requires an existing
/// frame.
BvhPose compute_pose(const BvhMotion& motion, std::optional<std::size_t> frame) {
  BvhPose pose;
  for (std::size_t j = 0; j < motion.joints.size(); ++j) {
    const BvhJoint& joint = motion.joints[j];
    const double* numbers = motion.values.data() + frame.value_or(0) * motion.numbers + joint.first_number;
    glm::dmat3 rotation(1.0);
    sim::Vec3 place = joint.offset;
    for (std::size_t k = 0; frame && k < joint.channels.size(); ++k) {
      const int kind = joint.channels[k];
      if (kind < 3) {
        place[kind] = numbers[k];
      } else {
        rotation = rotation * make_axis_rotation(kind - 3, numbers[k]);
      }
    }
    const bool is_root = j == 0;
    pose.positions.push_back(is_root ? place : pose.positions[joint.parent] + pose.rotations[joint.parent] * place);
    pose.rotations.push_back(is_root ? rotation : pose.rotations[joint.parent] * rotation);
  }
  return pose;
}

constexpr std::size_t no_joint = static_cast<std::size_t>(-1);
constexpr std::size_t max_names = 12;

/// Mark in the names of nodes that assimp inserts for the pivots of FBX; the joint's name stands before it.
constexpr std::string_view pivot_mark = "_$AssimpFbx$_";

/// Returns the rotation from the axes of a model with this axis up to the scene's axes.
glm::dmat3 into_scene(ModelAxis up) {
  Placement placement;
  placement.up = up;
  return {placement({1, 0, 0}), placement({0, 1, 0}), placement({0, 0, 1})};
}

std::string join_some_names(std::vector<std::string> names) {
  const std::size_t count = names.size();
  names.resize(std::min(count, max_names));
  return join(names) + (count > max_names ? fmt::format(" and {} more", count - max_names) : "");
}

struct Skeletons {
  std::vector<std::string> node_parts;
  std::vector<std::string> joint_parts;
};

Skeletons match_skeletons(const Rig& rig, const BvhMotion& motion) {
  const auto name_of = [](const RigNode& n) { return n.name.find(pivot_mark) == std::string::npos ? n.name : ""; };
  return {parts_of_joints(collect<std::string>(rig.nodes, name_of)),
          parts_of_joints(collect<std::string>(motion.joints, &BvhJoint::name))};
}

/// Returns, per node of the rig, the joint of the motion, or `no_joint`. Each joint moves the first node of its part.
std::vector<std::size_t> matched_joints(const Skeletons& skeletons) {
  std::map<std::string, std::size_t> joint_of;
  for (std::size_t j = 0; j < skeletons.joint_parts.size(); ++j) {
    joint_of.emplace(skeletons.joint_parts[j], j);
  }
  joint_of.erase("");
  std::vector<std::size_t> matched;
  for (const std::string& part : skeletons.node_parts) {
    const auto found = joint_of.find(part);
    matched.push_back(found == joint_of.end() ? no_joint : found->second);
    if (found != joint_of.end()) joint_of.erase(found);
  }
  return matched;
}

struct HipsMotion {
  sim::Index node = no_node;  ///< no_node if the hips are not moved
  std::size_t joint = 0;
  sim::Vec3 zero = sim::Vec3(0.0);  ///< position of the motion's hips that corresponds to the body's stored hips
  double ratio = 1.0;               ///< units of the body per unit of the motion
};

class BvhFrames final : public FrameSource {
 public:
  BvhFrames(std::shared_ptr<const Rig> rig, ModelAxis up, BvhMotion motion, std::vector<std::size_t> joint_of,
            const HipsMotion& hips, const glm::dmat3& motion_into_scene)
      : rig_(std::move(rig)),
        motion_(std::move(motion)),
        joint_of_(std::move(joint_of)),
        hips_(hips),
        into_body_(glm::transpose(into_scene(up)) * motion_into_scene),
        stored_(stored_pose(*rig_)) {}

  std::size_t frames() const override { return motion_.frames; }
  std::size_t vertices() const override { return rig_->in_part.size(); }
  std::optional<double> rate_hz() const override { return 1.0 / motion_.frame_time_s; }
  void read(std::size_t frame, std::span<sim::Vec3> positions) const override {
    pose_vertices(*rig_, *pose(frame), positions);
  }
  std::optional<RigPose> pose(std::size_t frame) const override { return pose_of(compute_pose(motion_, frame)); }

 private:
  /// Motion of a node since the stored pose: a point x moves to `to` + `rotation` * (x - `from`).
  struct NodeTransform {
    glm::dmat3 rotation = glm::dmat3(1.0);
    sim::Vec3 from = sim::Vec3(0.0);
    sim::Vec3 to = sim::Vec3(0.0);
  };

  RigPose pose_of(const BvhPose& joints) const {
    RigPose posed = stored_;
    std::vector<NodeTransform> moved(rig_->nodes.size());
    for (sim::Index n = 0; n < moved.size(); ++n) {
      const sim::Index parent = rig_->nodes[n].parent;
      NodeTransform& here = moved[n];
      here.from = here.to = sim::Vec3(stored_.to_model[n][3]);
      if (parent != no_node) {
        here.rotation = moved[parent].rotation;
        here.to = moved[parent].to + here.rotation * (here.from - moved[parent].from);
      }
      if (joint_of_[n] != no_joint) {
        here.rotation = into_body_ * joints.rotations[joint_of_[n]] * glm::transpose(into_body_);
      }
      if (n == hips_.node) {
        here.to = here.from + into_body_ * ((joints.positions[hips_.joint] - hips_.zero) * hips_.ratio);
      }
      glm::dmat4 transform(here.rotation);
      transform[3] = glm::dvec4(here.to - here.rotation * here.from, 1.0);
      posed.to_model[n] = transform * stored_.to_model[n];
    }
    return posed;
  }

  std::shared_ptr<const Rig> rig_;
  BvhMotion motion_;
  std::vector<std::size_t> joint_of_;
  HipsMotion hips_;
  glm::dmat3 into_body_;
  RigPose stored_;
};

/// Returns the axis of the motion that is up, from its hips and its head.
ModelAxis find_up_axis(const BvhMotion& motion, const Skeletons& skeletons) {
  const BvhPose zero = compute_pose(motion, std::nullopt);
  const auto place_of = [&](const char* part) {
    const auto found = std::ranges::find(skeletons.joint_parts, part);
    return found == skeletons.joint_parts.end()
               ? zero.positions.front()
               : zero.positions[static_cast<std::size_t>(found - skeletons.joint_parts.begin())];
  };
  const sim::Vec3 upwards = place_of("head") - place_of("hips");
  return upwards.z > std::abs(upwards.y) && upwards.z > std::abs(upwards.x) ? ModelAxis::z : ModelAxis::y;
}

/// Returns the height of the lowest vertex, in the body's unit.
double find_lowest_height(const Rig& rig, const RigPose& pose, const glm::dmat3& into_scene) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const sim::Vec3& position : posed_vertices(rig, pose)) lowest = std::min(lowest, (into_scene * position).y);
  return lowest;
}

HipsMotion hips_motion(const Rig& rig, ModelAxis up, const BvhMotion& motion, const Skeletons& skeletons,
                       const std::vector<std::size_t>& joint_of, const glm::dmat3& motion_into_scene,
                       std::size_t first) {
  const auto found = std::ranges::find(skeletons.node_parts, "hips");
  const auto node = static_cast<std::size_t>(found - skeletons.node_parts.begin());
  if (found == skeletons.node_parts.end() || joint_of[node] == no_joint) return {};
  HipsMotion hips{static_cast<sim::Index>(node), joint_of[node]};
  const RigPose stored = stored_pose(rig);
  const BvhPose zero = compute_pose(motion, std::nullopt);
  const glm::dmat3 body_into_scene = into_scene(up);
  const auto body_height = [&](std::size_t n) { return (body_into_scene * sim::Vec3(stored.to_model[n][3])).y; };
  const auto height = [&](std::size_t j) { return (motion_into_scene * zero.positions[j]).y; };
  double body_hips = 0.0, motion_hips = 0.0;
  for (std::size_t n = 0; n < joint_of.size(); ++n) {
    if (joint_of[n] != no_joint) {
      body_hips = std::max(body_hips, body_height(node) - body_height(n));
      motion_hips = std::max(motion_hips, height(hips.joint) - height(joint_of[n]));
    }
  }
  if (!(body_hips > 0.0 && motion_hips > 0.0)) return {};
  hips.ratio = body_hips / motion_hips;
  // Many files have the root's zero pose at the origin, while its frames stand on a floor there. The body stands on its
  // lowest vertex.
  sim::Vec3 zero_in_scene = motion_into_scene * compute_pose(motion, first).positions[hips.joint];
  zero_in_scene.y = height(hips.joint) > 0.5 * motion_hips
                        ? height(hips.joint)
                        : (body_height(node) - find_lowest_height(rig, stored, body_into_scene)) / hips.ratio;
  hips.zero = glm::transpose(motion_into_scene) * zero_in_scene;
  return hips;
}

void require_match(const Rig& rig, const BvhMotion& motion, const std::vector<std::size_t>& joint_of) {
  if (std::ranges::any_of(joint_of, [](std::size_t joint) { return joint != no_joint; })) return;
  std::vector<std::string> joints = collect<std::string>(motion.joints, &BvhJoint::name);
  const auto node_of = [&](const RigBone& bone) { return rig.nodes[bone.node].name; };
  const std::vector<std::string> nodes = collect<std::string>(rig.bones, node_of);
  std::erase(joints, "");
  throw InputError("found the joints " + join_some_names(joints) + ", none of which is one of the body's; expected " +
                   join_some_names(nodes));
}

std::vector<std::string> remarks_on(const Rig& rig, const BvhMotion& motion, const Skeletons& skeletons,
                                    const std::vector<std::size_t>& joint_of, const HipsMotion& hips) {
  std::vector<std::string> still;
  std::vector<std::string> without;
  for (std::size_t n = 0; n < joint_of.size(); ++n) {
    if (joint_of[n] == no_joint && is_main_part(skeletons.node_parts[n])) still.push_back(rig.nodes[n].name);
  }
  for (std::size_t j = 0; j < motion.joints.size(); ++j) {
    if (is_main_part(skeletons.joint_parts[j]) && std::ranges::find(joint_of, j) == joint_of.end()) {
      without.push_back(motion.joints[j].name);
    }
  }
  std::vector<std::string> remarks;
  if (!still.empty()) remarks.push_back("joints that its motion does not turn: " + join_some_names(still));
  if (!without.empty()) remarks.push_back("joints of its motion that it does not have: " + join_some_names(without));
  if (hips.node == no_node) {
    remarks.emplace_back("it stays where it is, as its motion and it have no hips in common");
  }
  return remarks;
}

/// Reads a BVH file. Throws InputError that names the file, the line, the found and the expected word.
BvhMotion read_bvh(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  try {
    return BvhReader(text).read();
  } catch (const InputError& error) {
    throw InputError("cannot read a motion from '" + file.string() + "': " + error.what());
  }
}

/// Moves a body by a BVH motion. Joints are matched by their names (rig_pose.hpp). The stored pose of the body
/// corresponds to the zero pose of the motion: a matched joint is rotated from there like the motion's joint from its
/// zero pose, in the axes of the scene. Other joints move rigidly with the joint above them. The hips move like the
/// motion's, times the ratio of the heights of the hips over the lowest joint that both have. Sideways they start from
/// their position in frame `first`. Vertically they start from their zero pose. If the zero pose has its hips near the
/// ground, they start from the height of the body's hips over its lowest vertex. Throws InputError if the body's
/// vertices follow no joints, or if no joint is matched, with the names of both.
OpenedMotion retarget(std::shared_ptr<const Rig> rig, ModelAxis up, BvhMotion motion, std::size_t first) {
  if (rig->influences.empty()) {
    throw InputError(
        "found a motion of joints, and a body whose vertices follow no joints; expected one with a skin, "
        "such as glTF, FBX or Collada may have");
  }
  const Skeletons skeletons = match_skeletons(*rig, motion);
  std::vector<std::size_t> joint_of = matched_joints(skeletons);
  require_match(*rig, motion, joint_of);
  const ModelAxis motion_up = find_up_axis(motion, skeletons);
  const glm::dmat3 motion_into_scene = into_scene(motion_up);
  const HipsMotion hips =
      hips_motion(*rig, up, motion, skeletons, joint_of, motion_into_scene, std::min(first, motion.frames - 1));
  OpenedMotion retargeted{{}, nullptr, remarks_on(*rig, motion, skeletons, joint_of, hips)};
  if (motion_up == ModelAxis::z) {
    retargeted.remarks.emplace_back("up in its motion is z, as its head is there");
  }
  retargeted.frames =
      std::make_unique<BvhFrames>(std::move(rig), up, std::move(motion), std::move(joint_of), hips, motion_into_scene);
  return retargeted;
}

}  // namespace

OpenedMotion open_bvh(const BodySource& source, const std::shared_ptr<const Rig>& rig, ModelAxis up) {
  BvhMotion motion = read_bvh(source.motion);
  const double rate_hz = source.frame_rate_hz.value_or(1.0 / motion.frame_time_s);
  const auto first = static_cast<std::size_t>(std::round(std::min(source.start_s * rate_hz, 1e9)));
  try {
    OpenedMotion opened = retarget(rig, up, std::move(motion), first);
    opened.file = source.motion;
    return opened;
  } catch (const InputError& error) {
    throw InputError("'" + source.motion.string() + "': " + error.what());
  }
}

}  // namespace taut::app
