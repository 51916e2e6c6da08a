#pragma once

#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// The size of a window, and how its parts are arranged.
struct WindowLayout {
  int width_px = 0;
  int height_px = 0;
  float scale = 1.0F;     ///< of text and controls
  bool has_panel = true;  ///< the user has not hidden the panel
};

/// The right end of the wind slider. Keys do not go beyond it either.
inline constexpr double strongest_wind_m_per_s = 20.0;

/// Grey of the background behind the panel. The framebuffer is cleared to it, which is cheaper than drawing
/// it.
inline constexpr float behind_panel_grey = 0.965F;

/// The part of the window that shows the scene.
ViewArea scene_area(const WindowLayout& layout);
/// The part of it that shows one garment: its left half where a second one is shown beside it.
ViewArea garment_area(const ViewerState& state, const WindowLayout& layout);

/// Makes the whole user interface for one frame. Changes settings in `state` as the user does, and notes
/// there what else the user asked for. Call it between begin_frame and end_frame of UserInterface.
void lay_out(ViewerState& state, const WindowLayout& layout);

/// Whether a hint for the item under the pointer is about to appear.
bool is_hint_due(const ViewerState& state);

/// Explains an item of the panel, with its unit; a key of scenes as taut help scene does. Empty for other
/// names.
std::string hint_for(const std::string& name);
/// assets/texts/hints.toml: those of the panel's own items, by name.
extern const char* const hint_texts;

}  // namespace taut::app
