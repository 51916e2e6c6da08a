#pragma once

#include <filesystem>
#include <memory>

#include "app/bodies/frame_source.hpp"

namespace taut::app {

/// Opens a point cache (PC2, version 1; Autodesk's "Point Oven" layout). It holds 32-bit numbers, lowest byte
/// first. How fast it is played is not in it. Throws InputError that names the file, where, what was found
/// and what was expected.
std::unique_ptr<const FrameSource> open_pc2(const std::filesystem::path& file);

/// Opens a LightWave motion cache (MDD): the number of frames and of points, the time of each frame in
/// seconds, then positions, as 32-bit numbers, highest byte first. Its rate is the mean one of its times.
/// Throws InputError as above.
std::unique_ptr<const FrameSource> open_mdd(const std::filesystem::path& file);

}  // namespace taut::app
