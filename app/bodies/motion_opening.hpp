#pragma once

#include "app/bodies/frame_source.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// The motion of a body and the file it is in.
struct OpenedMotion {
  std::filesystem::path file;
  std::unique_ptr<const FrameSource> frames = nullptr;  ///< null: the body keeps its shape
  std::vector<std::string> remarks = {};                ///< what was chosen and did not fit, for people
};

/// How often a clip is looked at, and how fast a motion is played that does not say, if nobody asks for more.
inline constexpr double usual_frame_rate_hz = 60.0;

/// Opens the motion that a body's source names, by the ending of its file; without one, the clip of its model
/// that is asked for. `rig` is that of the model, empty if it has none, and `up` the direction of the
/// model that is up. Throws InputError that names the file.
OpenedMotion open_motion(const BodySource& source, const std::shared_ptr<const Rig>& rig, ModelAxis up);

/// Where a motion that repeats goes on after its last frame.
struct LoopBegin {
  std::size_t frame = 0;
  double furthest_m = 0.0;  ///< that a vertex is from where it is in the last frame
  bool meets = false;       ///< within 1 mm: the last frame is this one again
};

/// Returns the earliest frame at which every vertex is within 1 mm of where it is in the last one, so that
/// what leads into a motion is not repeated. It is looked for in the first half and the first two seconds; if
/// there is none, the first frame is returned. Throws what the motion throws.
LoopBegin find_loop_begin(const sim::BodyFrames& motion, std::size_t vertices);

/// How a motion that repeats goes on, for people.
std::string describe(const LoopBegin& begin);

/// Returns the motion from the frame `first` on, and again from `begin` on without end. Throws InputError if
/// a vertex goes further from the last frame to the begin than it may in a frame (PlacedFrames).
std::shared_ptr<const sim::BodyFrames> looped(std::shared_ptr<const sim::BodyFrames> motion, const LoopBegin& begin,
                                              std::size_t first);

inline constexpr std::size_t no_clip = static_cast<std::size_t>(-1);

/// Returns the names of the clips; of one without a name its number, counted from 1.
std::vector<std::string> names_of_clips(const Rig& rig);

/// Returns "'Walk' (1.2 s), 'Wave' (3 s)", or "none".
std::string describe_clips(const Rig& rig);

}  // namespace taut::app
