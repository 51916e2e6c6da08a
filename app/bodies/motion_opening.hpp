#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/bodies/frame_source.hpp"
#include "app/models/rig.hpp"
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

}  // namespace taut::app
