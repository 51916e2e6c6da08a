#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/bodies/frame_source.hpp"
#include "app/bodies/rig_pose.hpp"

namespace taut::app {

/// The frames of a clip, looked at `rate_hz` times a second: the last frame is its end or the first moment
/// after it. `clip` is an index into the clips of the rig.
std::unique_ptr<const FrameSource> frames_of_clip(std::shared_ptr<const Rig> rig, std::size_t clip,
                                                  double rate_hz);

/// Returns the clip that a body's source asks for by name: the first if it asks for none, and no_clip if
/// there is none or it asks for "none". Throws InputError that lists the clips there are.
std::size_t clip_asked_for(const Rig& rig, const std::string& name);

inline constexpr std::size_t no_clip = static_cast<std::size_t>(-1);

/// Returns the names of the clips; of one without a name its number, counted from 1.
std::vector<std::string> names_of_clips(const Rig& rig);

/// Returns "'Walk' (1.2 s), 'Wave' (3 s)", or "none".
std::string describe_clips(const Rig& rig);

/// Returns the rig with one clip, of all of its clips at once; of a node that several move the last of them
/// holds.
std::shared_ptr<const Rig> with_all_clips(const Rig& rig);

/// Requires that the clip moves something and nothing that the model does not have. Throws InputError.
void require_playable(const Rig& rig, std::size_t clip);

}  // namespace taut::app
