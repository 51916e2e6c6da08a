#pragma once

#include <span>

#include "renderer/gl/frame_block.hpp"

namespace taut::renderer {

/// Returns the bounds of surfaces and marks in the picture, rounded outwards to blocks of 32 pixels. Zero
/// wide when there are none. `world_to_clip` is that of the whole picture. `surfaces`: the frame's surfaces
/// and the meshes of its spheres.
Tile screen_bounds(const FrameView& frame, std::span<const SurfaceView> surfaces,
                   const glm::mat4& world_to_clip, const PictureSettings& settings);

/// Returns whether any surface or mark has a point below y = height_m, metres.
bool reaches_below(float height_m, const FrameView& frame, std::span<const SurfaceView> surfaces);

}  // namespace taut::renderer
