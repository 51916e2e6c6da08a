#include "app/bodies/motion_opening.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/bodies/bvh_frames.hpp"
#include "app/bodies/frame_source.hpp"

namespace taut::app {
namespace {

class ClipFrames final : public FrameSource {
 public:
  ClipFrames(std::shared_ptr<const Rig> rig, std::size_t clip, double rate_hz)
      : rig_(std::move(rig)), clip_(clip), rate_hz_(rate_hz) {}

  std::size_t frames() const override {
    // Times in files are of single precision: an end that is a frame must not become two.
    constexpr double rounded_off = 1e-3;
    return 1 +
           static_cast<std::size_t>(std::ceil(std::max(0.0, rig_->clips[clip_].duration_s * rate_hz_ - rounded_off)));
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
  for (const RigInfluence& influence : rig.influences) followed[rig.bones[influence.bone].node] = true;
  for (std::size_t n = followed.size(); n-- > 0;) {
    if (followed[n] && rig.nodes[n].parent != no_node) followed[rig.nodes[n].parent] = true;
  }
  return followed;
}

/// The frames of a clip, looked at `rate_hz` times a second: the last frame is its end or the first moment
/// after it. `clip` is an index into the clips of the rig.
std::unique_ptr<const FrameSource> frames_of_clip(std::shared_ptr<const Rig> rig, std::size_t clip, double rate_hz) {
  return std::make_unique<ClipFrames>(std::move(rig), clip, rate_hz);
}

/// Returns the clip that a body's source asks for by name: the first if it asks for none, and no_clip if
/// there is none or it asks for "none". Throws InputError that lists the clips there are.
std::size_t clip_asked_for(const Rig& rig, const std::string& name) {
  if (name == "none" || (name.empty() && rig.clips.empty())) return no_clip;
  for (std::size_t clip = 0; clip < rig.clips.size(); ++clip) {
    if (name.empty() || name_of(rig, clip) == name) return clip;
  }
  throw InputError("it has no animation '" + name + "'; expected one of those it has: " + describe_clips(rig));
}

/// Returns the rig with one clip, of all of its clips at once; of a node that several move the last of them
/// holds.
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

/// Requires that the clip moves something and nothing that the model does not have. Throws InputError.
void require_playable(const Rig& rig, std::size_t clip) {
  const RigClip& asked = rig.clips[clip];
  const std::string animation = "its animation '" + name_of(rig, clip) + '\'';
  if (!asked.unknown.empty()) {
    throw InputError(animation + " moves '" + asked.unknown.front() + "', which it does not have");
  }
  const std::vector<bool> followed = followed_nodes(rig);
  const bool moves =
      std::ranges::any_of(asked.channels, [&](const RigChannel& channel) { return followed[channel.node]; });
  if (!moves && asked.targets.empty()) {
    throw InputError(
        "{} moves {} nodes, and no vertex follows any of them; expected a mesh that is bound to its joints", animation,
        asked.channels.size());
  }
}

constexpr double meets_within_m = 1e-3;
constexpr double longest_lead_in_s = 2.0;

/// More frames than any run shows, which a number of 32 bits still counts.
constexpr std::size_t endless = std::size_t{1} << 31U;

double furthest_m(const std::vector<sim::Vec3>& from_m, const std::vector<sim::Vec3>& to_m) {
  double furthest = 0.0;
  for (std::size_t v = 0; v < from_m.size(); ++v) {
    furthest = std::max(furthest, glm::distance(from_m[v], to_m[v]));
  }
  return furthest;
}

class LoopedFrames final : public sim::BodyFrames {
 public:
  LoopedFrames(std::shared_ptr<const sim::BodyFrames> motion, const LoopBegin& begin, std::size_t first)
      : motion_(std::move(motion)),
        begin_(begin.frame),
        period_(motion_->count() - (begin.meets ? begin.frame + 1 : 0)),
        first_(first) {}

  std::size_t count() const override { return endless; }
  double rate_hz() const override { return motion_->rate_hz(); }
  void positions_in(std::size_t frame, std::span<sim::Vec3> positions_m) const override {
    const std::size_t at = first_ + frame;
    motion_->positions_in(at < motion_->count() ? at : begin_ + (at - begin_) % period_, positions_m);
  }

 private:
  std::shared_ptr<const sim::BodyFrames> motion_;
  std::size_t begin_;
  std::size_t period_;
  std::size_t first_;
};

OpenedMotion open_clip(const BodySource& source, const std::shared_ptr<const Rig>& own) try {
  OpenedMotion opened{source.file};
  const bool plays_all = source.clip == "all" && !own->clips.empty();
  const std::shared_ptr<const Rig> rig = plays_all ? with_all_clips(*own) : own;
  const std::size_t clip = clip_asked_for(*rig, source.clip);
  if (clip == no_clip) return opened;
  require_playable(*rig, clip);
  if (source.clip.empty()) {
    opened.remarks.push_back("it plays the first of its animations: " + describe_clips(*rig) + " (clip, --body-clip)");
  }
  opened.frames = frames_of_clip(rig, clip, source.frame_rate_hz.value_or(usual_frame_rate_hz));
  return opened;
} catch (const InputError& error) {
  throw InputError("'" + source.file.string() + "': " + error.what());
}

OpenedMotion open_bvh(const BodySource& source, const std::shared_ptr<const Rig>& rig, ModelAxis up) {
  BvhMotion motion = read_bvh(source.motion);
  const double rate_hz = source.frame_rate_hz.value_or(1.0 / motion.frame_time_s);
  const auto first = static_cast<std::size_t>(std::round(std::min(source.start_s * rate_hz, 1e9)));
  try {
    RetargetedMotion retargeted = retarget(rig, up, std::move(motion), first);
    return {source.motion, std::move(retargeted.frames), std::move(retargeted.remarks)};
  } catch (const InputError& error) {
    throw InputError("'" + source.motion.string() + "': " + error.what());
  }
}

}  // namespace

std::vector<std::string> names_of_clips(const Rig& rig) {
  std::vector<std::string> names;
  for (std::size_t clip = 0; clip < rig.clips.size(); ++clip) names.push_back(name_of(rig, clip));
  return names;
}

std::string describe_clips(const Rig& rig) {
  std::vector<std::string> texts;
  for (std::size_t clip = 0; clip < rig.clips.size(); ++clip) {
    texts.push_back(fmt::format("'{}' ({:.3g} s)", name_of(rig, clip), rig.clips[clip].duration_s));
  }
  return texts.empty() ? "none" : joined(texts);
}

LoopBegin find_loop_begin(const sim::BodyFrames& motion, std::size_t vertices) {
  std::vector<sim::Vec3> last_m(vertices);
  std::vector<sim::Vec3> frame_m(vertices);
  motion.positions_in(motion.count() - 1, last_m);
  const auto lead_in = static_cast<std::size_t>(longest_lead_in_s * motion.rate_hz());
  const std::size_t latest = std::min((motion.count() - 1) / 2, lead_in);
  LoopBegin first;
  for (std::size_t frame = 0; frame <= latest; ++frame) {
    throw_if_interrupted();
    motion.positions_in(frame, frame_m);
    const double apart_m = furthest_m(frame_m, last_m);
    if (apart_m <= meets_within_m) return {frame, apart_m, motion.count() > 1};
    first = frame == 0 ? LoopBegin{0, apart_m, false} : first;
  }
  return first;
}

std::string describe(const LoopBegin& begin) {
  return begin.meets ? fmt::format("repeated, its motion goes on from frame {}, which its last is again", begin.frame)
                     : fmt::format(
                           "repeated, its motion goes on from its first frame, from which its last is up to {:.3g} m "
                           "away",
                           begin.furthest_m);
}

std::shared_ptr<const sim::BodyFrames> looped(std::shared_ptr<const sim::BodyFrames> motion, const LoopBegin& begin,
                                              std::size_t first) {
  if (begin.furthest_m > furthest_in_frame_m) {
    throw InputError(
        "found a motion to be repeated (loop, --body-loop) whose last frame is up to {:.3g} m from its "
        "first, expected at most {:g} m",
        begin.furthest_m, furthest_in_frame_m);
  }
  return std::make_shared<const LoopedFrames>(std::move(motion), begin, first);
}

OpenedMotion open_motion(const BodySource& source, const std::shared_ptr<const Rig>& rig, ModelAxis up) {
  if (source.motion.empty()) return open_clip(source, rig);
  const std::string ending = lower_case(source.motion.extension().string());
  if (ending == ".pc2") return {source.motion, open_pc2(source.motion)};
  if (ending == ".mdd") return {source.motion, open_mdd(source.motion)};
  if (ending == ".bvh") return open_bvh(source, rig, up);
  throw InputError("'" + source.motion.string() + "': expected a motion that ends in .pc2, .mdd or .bvh");
}

}  // namespace taut::app
