#pragma once

#include "renderer/frame_view.hpp"

namespace taut::renderer {

/// Throws std::invalid_argument that names the part ("surface 2: ...") and what was found and expected.
void check_frame(const FrameView& frame);
void check_settings(const PictureSettings& settings);

}  // namespace taut::renderer
