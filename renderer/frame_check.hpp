#pragma once

#include "renderer/frame_view.hpp"

namespace taut::renderer {

/// Whether the frame keeps what frame_view.hpp requires: lengths of spans, indices below n, finite positions
/// and normals.
bool is_sound(const FrameView& frame);

/// Whether every setting is in its range.
bool is_sound(const PictureSettings& settings);

/// Throws std::invalid_argument unless both are sound and the camera's eye and target differ and are no
/// farther than 1e9 m.
void check(const FrameView& frame, const PictureSettings& settings);

}  // namespace taut::renderer
