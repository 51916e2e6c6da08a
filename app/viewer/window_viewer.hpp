#pragma once

#include <filesystem>

#include "app/drawing/drawn_scene.hpp"
#include "app/viewer/session/session.hpp"

namespace taut::app {

/// Opens a window and returns when the user closes it. All input is recorded to `record_to` unless that is
/// empty. Throws renderer::ContextError without a display or OpenGL, InputError if a file cannot be written,
/// Interrupted.
void view_in_window(const DrawnScene& scene, const SessionStart& start,
                    const std::filesystem::path& keep_folder, const std::filesystem::path& record_to);

}  // namespace taut::app
