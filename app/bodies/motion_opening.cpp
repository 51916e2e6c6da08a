#include "app/bodies/motion_opening.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>

#include "app/base/errors.hpp"
#include "app/bodies/bvh_frames.hpp"
#include "app/bodies/obj_sequence.hpp"
#include "app/bodies/point_cache.hpp"
#include "app/bodies/rig_frames.hpp"

namespace taut::app {
namespace {

std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

OpenedMotion open_clip(const BodySource& source, const std::shared_ptr<const Rig>& own) try {
  OpenedMotion opened{source.file};
  const bool plays_all = source.clip == "all" && !own->clips.empty();
  const std::shared_ptr<const Rig> rig = plays_all ? with_all_clips(*own) : own;
  const std::size_t clip = clip_asked_for(*rig, source.clip);
  if (clip == no_clip) {
    return opened;
  }
  require_playable(*rig, clip);
  if (source.clip.empty()) {
    opened.remarks.push_back("it plays the first of its animations: " + describe_clips(*rig) +
                             " (clip, --body-clip)");
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

OpenedMotion open_motion(const BodySource& source, const std::shared_ptr<const Rig>& rig, ModelAxis up) {
  if (source.motion.empty()) {
    return open_clip(source, rig);
  }
  const std::string ending = ending_of(source.motion);
  if (names_obj_sequence(source.motion)) {
    return {source.motion, open_obj_sequence(source.motion)};
  }
  if (ending == ".pc2") {
    return {source.motion, open_pc2(source.motion)};
  }
  if (ending == ".mdd") {
    return {source.motion, open_mdd(source.motion)};
  }
  if (ending == ".bvh") {
    return open_bvh(source, rig, up);
  }
  throw InputError(
      "'" + source.motion.string() +
      "': expected a motion that ends in .pc2, .mdd or .bvh, or a folder or pattern of OBJ files");
}

}  // namespace taut::app
