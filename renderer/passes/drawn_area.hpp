#pragma once

#include <span>

#include "renderer/gl/frame_block.hpp"

namespace taut::renderer {

/// The part of the picture that surfaces and marks can touch, in whole blocks of pixels; nothing wide when
/// they touch none. `world_to_clip` is that of the whole picture. `surfaces` stands for the frame's own
/// surfaces and balls.
Tile drawn_area(const FrameView& frame, std::span<const SurfaceView> surfaces, const glm::mat4& world_to_clip,
                const PictureSettings& settings);

/// Whether any of that is lower than a height in metres.
bool reaches_below(float height_m, const FrameView& frame, std::span<const SurfaceView> surfaces);

}  // namespace taut::renderer
