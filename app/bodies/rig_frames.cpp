#include "app/bodies/rig_frames.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/base/errors.hpp"
#include "app/base/suggest.hpp"

namespace taut::app {
namespace {

class ClipFrames final : public FrameSource {
 public:
  ClipFrames(std::shared_ptr<const Rig> rig, std::size_t clip, double rate_hz)
      : rig_(std::move(rig)), clip_(clip), rate_hz_(rate_hz) {}

  std::size_t frames() const override {
    // Times in files are of single precision: an end that is a frame must not become two.
    constexpr double rounded_off = 1e-3;
    return 1 + static_cast<std::size_t>(
                   std::ceil(std::max(0.0, rig_->clips[clip_].duration_s * rate_hz_ - rounded_off)));
  }
  std::size_t vertices() const override { return rig_->in_part.size(); }
  std::optional<double> rate_hz() const override { return rate_hz_; }
  void read(std::size_t frame, std::span<sim::Vec3> positions) const override {
    pose_vertices(*rig_, *pose(frame), positions);
  }
  std::optional<RigPose> pose(std::size_t frame) const override {
    return pose_at(*rig_, rig_->clips[clip_], static_cast<double>(frame) / rate_hz_);
  }

 private:
  std::shared_ptr<const Rig> rig_;
  std::size_t clip_;
  double rate_hz_;
};

std::string name_of(const Rig& rig, std::size_t clip) {
  const std::string& name = rig.clips[clip].name;
  return name.empty() ? fmt::format("{}", clip + 1) : name;
}

/// Per node whether a vertex goes with it, or with one below it.
std::vector<bool> followed_nodes(const Rig& rig) {
  std::vector<bool> followed(rig.nodes.size(), false);
  for (const RigPart& part : rig.parts) {
    followed[part.node] = followed[part.node] || (!part.is_skinned && part.vertices > 0);
  }
  for (const RigInfluence& influence : rig.influences) {
    followed[rig.bones[influence.bone].node] = true;
  }
  for (std::size_t n = followed.size(); n-- > 0;) {
    if (followed[n] && rig.nodes[n].parent != no_node) {
      followed[rig.nodes[n].parent] = true;
    }
  }
  return followed;
}

}  // namespace

std::unique_ptr<const FrameSource> frames_of_clip(std::shared_ptr<const Rig> rig, std::size_t clip,
                                                  double rate_hz) {
  return std::make_unique<ClipFrames>(std::move(rig), clip, rate_hz);
}

std::size_t clip_asked_for(const Rig& rig, const std::string& name) {
  if (name == "none" || (name.empty() && rig.clips.empty())) {
    return no_clip;
  }
  for (std::size_t clip = 0; clip < rig.clips.size(); ++clip) {
    if (name.empty() || name_of(rig, clip) == name) {
      return clip;
    }
  }
  throw InputError("it has no animation '" + name +
                   "'; expected one of those it has: " + describe_clips(rig));
}

std::vector<std::string> names_of_clips(const Rig& rig) {
  std::vector<std::string> names;
  for (std::size_t clip = 0; clip < rig.clips.size(); ++clip) {
    names.push_back(name_of(rig, clip));
  }
  return names;
}

std::string describe_clips(const Rig& rig) {
  std::vector<std::string> texts;
  for (std::size_t clip = 0; clip < rig.clips.size(); ++clip) {
    texts.push_back(fmt::format("'{}' ({:.3g} s)", name_of(rig, clip), rig.clips[clip].duration_s));
  }
  return texts.empty() ? "none" : joined(texts);
}

std::shared_ptr<const Rig> with_all_clips(const Rig& rig) {
  auto whole = std::make_shared<Rig>(rig);
  RigClip all{"all", 0.0, {}, {}, {}};
  for (const RigClip& clip : rig.clips) {
    all.duration_s = std::max(all.duration_s, clip.duration_s);
    all.channels.insert(all.channels.end(), clip.channels.begin(), clip.channels.end());
    all.targets.insert(all.targets.end(), clip.targets.begin(), clip.targets.end());
    all.unknown.insert(all.unknown.end(), clip.unknown.begin(), clip.unknown.end());
  }
  whole->clips = {std::move(all)};
  return whole;
}

void require_playable(const Rig& rig, std::size_t clip) {
  const RigClip& asked = rig.clips[clip];
  const std::string animation = "its animation '" + name_of(rig, clip) + '\'';
  if (!asked.unknown.empty()) {
    throw InputError(animation + " moves '" + asked.unknown.front() + "', which it does not have");
  }
  const std::vector<bool> followed = followed_nodes(rig);
  const bool moves = std::any_of(asked.channels.begin(), asked.channels.end(),
                                 [&](const RigChannel& channel) { return followed[channel.node]; });
  if (!moves && asked.targets.empty()) {
    throw InputError(
        fmt::format("{} moves {} nodes, and no vertex follows any of them; expected a mesh that is "
                    "bound to its joints",
                    animation, asked.channels.size()));
  }
}

}  // namespace taut::app
