#include "app/bodies/frame_source.hpp"

#include <mutex>

#include "app/base/errors.hpp"
#include "app/base/words.hpp"

namespace taut::app {
namespace {

/// Number of frames that are cached. A step of the simulation needs two at its start and two at its end, a picture
/// needs two more.
constexpr std::size_t max_cached_frames = 6;

constexpr std::string_view pc2_signature{"POINTCACHE2", 12};  // with the zero at its end
constexpr std::size_t number_bytes = 4;
constexpr std::size_t position_bytes = 3 * number_bytes;

std::uint32_t number_at(const char* bytes) {
  std::uint32_t value = 0;
  for (std::size_t k = number_bytes; k-- > 0;) value = value << 8U | static_cast<std::uint8_t>(bytes[k]);
  return value;
}

[[noreturn]] void refuse(const SeekableFile& file, const std::string& reason) {
  throw InputError("cannot read frames from '" + file.path().string() + "': " + reason);
}

class PointCache final : public FrameSource {
 public:
  PointCache(SeekableFile file, std::size_t frames, std::size_t vertices)
      : file_(std::move(file)), frames_(frames), vertices_(vertices) {
    const std::uint64_t expected = pc2_header_bytes + frames * vertices * position_bytes;
    if (file_.size() != expected) {
      refuse(file_, fmt::format("found {} bytes, expected {} for {} frames of {} vertices", file_.size(), expected,
                                frames, vertices));
    }
  }

  std::size_t frames() const override { return frames_; }
  std::size_t vertices() const override { return vertices_; }
  std::optional<double> rate_hz() const override { return std::nullopt; }

  void read(std::size_t frame, std::span<sim::Vec3> positions) const override {
    std::vector<char> bytes(vertices_ * position_bytes);
    file_.read(pc2_header_bytes + frame * bytes.size(), bytes);
    const char* at = bytes.data();
    for (sim::Vec3& position : positions) {
      for (int axis = 0; axis < 3; ++axis, at += number_bytes) {
        position[axis] = static_cast<double>(std::bit_cast<float>(number_at(at)));
      }
    }
  }

 private:
  SeekableFile file_;
  std::size_t frames_;
  std::size_t vertices_;
};

/// Frames of a clip at `rate_hz`. The last frame is the end of the clip or the first moment after it. `clip` is an
/// index into the clips of the rig.
class ClipFrames final : public FrameSource {
 public:
  ClipFrames(std::shared_ptr<const Rig> rig, std::size_t clip, double rate_hz)
      : rig_(std::move(rig)), clip_(clip), rate_hz_(rate_hz) {}

  std::size_t frames() const override {
    // Files store times in single precision. A clip that ends at a frame must not get another one by rounding.
    constexpr double rounded_off = 1e-3;
    const double frames = std::ceil(std::max(0.0, rig_->clips[clip_].duration_s * rate_hz_ - rounded_off));
    return 1 + static_cast<std::size_t>(std::min(frames, double{sim::max_counter}));
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

std::string clip_name(const Rig& rig, std::size_t clip) {
  const std::string& name = rig.clips[clip].name;
  return name.empty() ? fmt::format("{}", clip + 1) : name;
}

/// Returns, per node, whether a vertex follows it or a node below it.
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

/// Returns the clip that a body's source names. Returns the first if it names none; no_clip if there is none or it
/// names "none". Throws InputError that lists the clips of the rig.
std::size_t clip_asked_for(const Rig& rig, const std::string& name) {
  if (name == "none" || (name.empty() && rig.clips.empty())) return no_clip;
  for (std::size_t clip = 0; clip < rig.clips.size(); ++clip) {
    if (name.empty() || clip_name(rig, clip) == name) return clip;
  }
  throw InputError("it has no animation '" + name + "'; expected one of those it has: " + describe_clips(rig));
}

/// Returns the rig with one clip that plays all of its clips at once. If several move a node, the last one applies.
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

/// Requires that the clip moves vertices, and no node that the model lacks. Throws InputError.
void require_playable(const Rig& rig, std::size_t clip) {
  const RigClip& asked = rig.clips[clip];
  const std::string animation = "its animation '" + clip_name(rig, clip) + '\'';
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
constexpr double max_lead_in_s = 2.0;

/// Number of frames beyond any run that still fits into 32 bits.
constexpr std::size_t endless = std::size_t{1} << 31U;

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

class PlacedFrames final : public sim::BodyFrames {
 public:
  PlacedFrames(std::filesystem::path motion, std::unique_ptr<const FrameSource> source, FileVertexPlaces places,
               double rate_hz, std::size_t first)
      : motion_(std::move(motion)),
        source_(std::move(source)),
        places_(std::move(places)),
        rate_hz_(rate_hz),
        first_(first) {}

  std::size_t count() const override { return source_->frames() - first_; }
  double rate_hz() const override { return rate_hz_; }
  void positions_in(std::size_t frame, std::span<sim::Vec3> positions_m) const override {
    const Positions placed_m = placed(frame);
    std::copy(placed_m->begin(), placed_m->end(), positions_m.begin());
  }

 private:
  using Positions = std::shared_ptr<const std::vector<sim::Vec3>>;
  struct Remembered {
    std::size_t frame = 0;
    Positions positions_m = {};
  };

  // Reads without a lock: two threads may read the same frame, and both get the same positions.
  Positions placed(std::size_t frame) const {
    if (Positions known = remembered(frame)) return known;
    Positions positions_m = read(frame);
    if (const Positions before_m = frame > 0 ? remembered(frame - 1) : nullptr) {
      require_near(frame, before_m, positions_m);
    }
    if (const Positions after_m = remembered(frame + 1)) require_near(frame + 1, positions_m, after_m);
    const std::lock_guard lock(mutex_);
    if (remembered_.size() == max_cached_frames) remembered_.erase(remembered_.begin());
    remembered_.push_back({frame, positions_m});
    return positions_m;
  }

  Positions remembered(std::size_t frame) const {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(remembered_, frame, &Remembered::frame);
    return found == remembered_.end() ? nullptr : found->positions_m;
  }

  Positions read(std::size_t frame) const {
    std::vector<sim::Vec3> in_file(source_->vertices());
    source_->read(first_ + frame, in_file);
    for (sim::Vec3& position : in_file) position = places_.motion_axes(position);
    std::vector<sim::Vec3> positions_m;
    positions_m.reserve(places_.file_vertex.size());
    for (const std::size_t v : places_.file_vertex) {
      const sim::Vec3& position_m = positions_m.emplace_back(places_.placement(in_file[v]));
      if (!std::isfinite(position_m.x + position_m.y + position_m.z)) {
        refuse(frame, v, fmt::format("found at {}, expected numbers", describe_point(in_file[v])));
      }
    }
    return std::make_shared<const std::vector<sim::Vec3>>(std::move(positions_m));
  }

  void require_near(std::size_t frame, const Positions& before_m, const Positions& after_m) const {
    for (std::size_t v = 0; v < after_m->size(); ++v) {
      const double moved_m = glm::distance((*before_m)[v], (*after_m)[v]);
      if (!(moved_m <= max_motion_per_frame_m)) {
        refuse(frame, places_.file_vertex[v],
               fmt::format("found at {} m, {:.3g} m from where it is in the frame before, expected at most {:g} m",
                           describe_point((*after_m)[v]), moved_m, max_motion_per_frame_m));
      }
    }
  }

  [[noreturn]] void refuse(std::size_t frame, std::size_t vertex, const std::string& reason) const {
    throw InputError("'{}': frame {}, vertex {}: {}", motion_.string(), first_ + frame, vertex, reason);
  }

  std::filesystem::path motion_;
  std::unique_ptr<const FrameSource> source_;
  FileVertexPlaces places_;
  double rate_hz_;
  std::size_t first_;
  mutable std::mutex mutex_;
  mutable std::vector<Remembered> remembered_;  ///< the newest last
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
  opened.frames = std::make_unique<ClipFrames>(rig, clip, source.frame_rate_hz.value_or(usual_frame_rate_hz));
  return opened;
} catch (const InputError& error) {
  throw InputError("'" + source.file.string() + "': " + error.what());
}

}  // namespace

std::shared_ptr<const sim::BodyFrames> placed_frames(std::filesystem::path motion,
                                                     std::unique_ptr<const FrameSource> source, FileVertexPlaces places,
                                                     double rate_hz, std::size_t first) {
  return std::make_shared<const PlacedFrames>(std::move(motion), std::move(source), std::move(places), rate_hz, first);
}

std::unique_ptr<const FrameSource> open_pc2(const std::filesystem::path& path) {
  SeekableFile file(path);
  std::string header(std::min<std::uint64_t>(pc2_header_bytes, file.size()), '\0');
  file.read(0, header);
  std::int32_t vertices = 0;
  std::int32_t frames = 0;
  try {
    sim::ByteReader in(header);
    in.require_text("what the file is", pc2_signature);
    in.get<std::int32_t>("the version", 1, 1);
    vertices = in.get<std::int32_t>("the number of vertices", 1, sim::max_counter);
    in.get<float>("the first frame");
    in.get<float>("the rate");
    frames = in.get<std::int32_t>("the number of frames", 1, sim::max_counter);
  } catch (const sim::BadBytes& error) {
    refuse(file, error.what());
  }
  return std::make_unique<PointCache>(std::move(file), frames, vertices);
}

std::string pc2_header(const PointCacheContent& content) {
  sim::ByteWriter out;
  out.put<std::int32_t>(1);
  out.put(static_cast<std::uint32_t>(content.vertices));
  out.put(static_cast<float>(content.first_frame));
  out.put(1.0F);  // one for each frame
  out.put(static_cast<std::uint32_t>(content.frames));
  return std::string(pc2_signature) + out.bytes();
}

std::string pc2_frame(std::span<const sim::Vec3> positions) {
  sim::ByteWriter out;
  for (const sim::Vec3& position : positions) {
    for (int axis = 0; axis < 3; ++axis) out.put(static_cast<float>(position[axis]));
  }
  return out.bytes();
}

std::optional<std::size_t> pc2_frames(const SeekableFile& file) {
  std::array<char, number_bytes> bytes = {};
  if (file.size() < pc2_header_bytes) return std::nullopt;
  file.read(pc2_header_bytes - bytes.size(), bytes);
  const std::size_t frames = number_at(bytes.data());
  return frames <= sim::max_counter ? std::optional(frames) : std::nullopt;
}

std::vector<std::string> names_of_clips(const Rig& rig) {
  std::vector<std::string> names;
  for (std::size_t clip = 0; clip < rig.clips.size(); ++clip) names.push_back(clip_name(rig, clip));
  return names;
}

std::string describe_clips(const Rig& rig) {
  std::vector<std::string> texts;
  for (std::size_t clip = 0; clip < rig.clips.size(); ++clip) {
    texts.push_back(fmt::format("'{}' ({:.3g} s)", clip_name(rig, clip), rig.clips[clip].duration_s));
  }
  return texts.empty() ? "none" : join(texts);
}

LoopBegin find_loop_begin(const sim::BodyFrames& motion, std::size_t vertices) {
  std::vector<sim::Vec3> last_m(vertices);
  std::vector<sim::Vec3> frame_m(vertices);
  motion.positions_in(motion.count() - 1, last_m);
  const auto lead_in = static_cast<std::size_t>(max_lead_in_s * motion.rate_hz());
  const std::size_t latest = std::min((motion.count() - 1) / 2, lead_in);
  LoopBegin first;
  for (std::size_t frame = 0; frame <= latest; ++frame) {
    throw_if_interrupted();
    motion.positions_in(frame, frame_m);
    double apart_m = 0.0;
    for (std::size_t v = 0; v < vertices; ++v) apart_m = std::max(apart_m, glm::distance(frame_m[v], last_m[v]));
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
                           begin.max_distance_m);
}

std::shared_ptr<const sim::BodyFrames> make_loop(std::shared_ptr<const sim::BodyFrames> motion, const LoopBegin& begin,
                                                 std::size_t first) {
  if (begin.max_distance_m > max_motion_per_frame_m) {
    throw InputError(
        "found a motion to be repeated (loop, --body-loop) whose last frame is up to {:.3g} m from its "
        "first, expected at most {:g} m",
        begin.max_distance_m, max_motion_per_frame_m);
  }
  return std::make_shared<const LoopedFrames>(std::move(motion), begin, first);
}

OpenedMotion open_motion(const BodySource& source, const std::shared_ptr<const Rig>& rig, ModelAxis up) {
  if (source.motion.empty()) return open_clip(source, rig);
  const std::string ending = lower_case(source.motion.extension().string());
  if (ending == ".pc2") return {source.motion, open_pc2(source.motion)};
  if (ending == ".bvh") return open_bvh(source, rig, up);
  throw InputError("'" + source.motion.string() + "': expected a motion that ends in .pc2 or .bvh");
}

}  // namespace taut::app
