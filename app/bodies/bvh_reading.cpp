#include "app/bodies/bvh_reading.hpp"

#include "app/base/counted.hpp"
#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "sim/mesh/elementary.hpp"

namespace taut::app {
namespace {

constexpr std::array<std::pair<std::string_view, BvhChannel>, 6> channel_names = {
    {{"Xposition", BvhChannel::x_position},
     {"Yposition", BvhChannel::y_position},
     {"Zposition", BvhChannel::z_position},
     {"Xrotation", BvhChannel::x_rotation},
     {"Yrotation", BvhChannel::y_rotation},
     {"Zrotation", BvhChannel::z_rotation}}};

constexpr std::size_t deepest = 200;
constexpr std::size_t most_frames = 10'000'000;

class BvhReader {
 public:
  explicit BvhReader(std::string_view text) : text_(text) {}

  BvhMotion read() {
    require("HIERARCHY");
    require("ROOT");
    read_joint(name_until_brace(), 0, 0);
    require("MOTION");
    require("Frames:");
    motion_.frames = whole_number("the number of frames", 1, most_frames);
    require("Frame");
    require("Time:");
    motion_.frame_time_s = number("the time of a frame in seconds");
    if (!(motion_.frame_time_s > 0.0)) reject("a time of a frame above 0");
    read_frames();
    return std::move(motion_);
  }

 private:
  void read_joint(std::string name, std::size_t parent, std::size_t depth);
  void read_channels(std::size_t joint);
  void read_frames();

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

  /// Names may have spaces.
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
    double value = 0.0;
    const char* const end = word_.data() + word_.size();
    const auto [stopped, error] = std::from_chars(word_.data(), end, value);
    if (error != std::errc() || stopped != end || !std::isfinite(value)) reject(what);
    return value;
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

void BvhReader::read_joint(std::string name, std::size_t parent, std::size_t depth) {
  if (depth > deepest) reject(fmt::format("at most {} joints below each other", deepest));
  const std::size_t joint = motion_.joints.size();
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

void BvhReader::read_channels(std::size_t joint) {
  const std::size_t count = whole_number("the number of channels", 0, channel_names.size());
  for (std::size_t k = 0; k < count; ++k) {
    const std::string_view name = next();
    std::optional<BvhChannel> found;
    for (const auto& [known, channel] : channel_names) found = name == known ? channel : found;
    if (!found) reject("a channel, such as Xposition or Zrotation");
    motion_.joints[joint].channels.push_back(*found);
  }
  motion_.joints[joint].first_number = motion_.numbers;
  motion_.numbers += count;
}

void BvhReader::read_frames() {
  const std::string what = counted(motion_.frames, "frame") + " of " + counted(motion_.numbers, "number");
  while (motion_.values.size() < motion_.frames * motion_.numbers) motion_.values.push_back(number(what));
  if (!next().empty()) reject("the end of the file after " + what);
}

glm::dmat3 turned_about(int axis, double degrees) {
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

}  // namespace

BvhMotion read_bvh(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  try {
    return BvhReader(text).read();
  } catch (const InputError& error) {
    throw InputError("cannot read a motion from '" + file.string() + "': " + error.what());
  }
}

BvhPose pose_in(const BvhMotion& motion, std::size_t frame) {
  BvhPose pose;
  for (std::size_t j = 0; j < motion.joints.size(); ++j) {
    const BvhJoint& joint = motion.joints[j];
    const double* numbers = motion.values.data() + frame * motion.numbers + joint.first_number;
    glm::dmat3 rotation(1.0);
    sim::Vec3 place = joint.offset;
    for (std::size_t k = 0; k < joint.channels.size(); ++k) {
      const int kind = static_cast<int>(joint.channels[k]);
      if (kind < 3) {
        place[kind] = numbers[k];
      } else {
        rotation = rotation * turned_about(kind - 3, numbers[k]);
      }
    }
    const bool is_root = j == 0;
    pose.positions.push_back(is_root ? place
                                     : pose.positions[joint.parent] + pose.rotations[joint.parent] * place);
    pose.rotations.push_back(is_root ? rotation : pose.rotations[joint.parent] * rotation);
  }
  return pose;
}

BvhPose zero_pose(const BvhMotion& motion) {
  BvhPose pose;
  for (const BvhJoint& joint : motion.joints) {
    const bool is_root = pose.positions.empty();
    pose.positions.push_back(is_root ? joint.offset : pose.positions[joint.parent] + joint.offset);
    pose.rotations.emplace_back(1.0);
  }
  return pose;
}

}  // namespace taut::app
