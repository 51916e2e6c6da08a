#pragma once

#include "renderer/frame_view.hpp"

namespace taut::renderer {

/// Throws std::invalid_argument unless the frame keeps what frame_view.hpp requires: lengths of spans,
/// indices below n, finite positions and normals, a camera with a direction. The message names the part
/// ("surface 2:
/// ..."), what was found and what was expected.
void check_frame(const FrameView& frame);
/// Throws std::invalid_argument unless every setting is in its range. The message names it, what was found
/// and what was expected.
void check_settings(const PictureSettings& settings);

}  // namespace taut::renderer
