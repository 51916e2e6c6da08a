#pragma once

#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// Size of a window and arrangement of its parts.
struct WindowLayout {
  int width_px = 0;
  int height_px = 0;
  float scale = 1.0F;     ///< scale of text and controls
  bool has_panel = true;  ///< false: the user has hidden the panel
};

/// Maximum of the wind slider, also for keys.
inline constexpr double strongest_wind_m_per_s = 20.0;

/// Grey of the background behind the panel. Clearing the framebuffer to it is cheaper than drawing it.
inline constexpr float behind_panel_grey = 0.965F;

/// Returns the area of the window that shows the scene.
ViewArea scene_area(const WindowLayout& layout);
/// Returns the area that shows one garment: the scene's area, or its left half if a second garment is shown beside it.
ViewArea garment_area(const ViewerState& state, const WindowLayout& layout);

/// Makes the user interface for one frame. Stores changed settings and other requests of the user in `state`. Call it
/// between begin_frame and end_frame of UserInterface.
void lay_out(ViewerState& state, const WindowLayout& layout);

/// Returns true if the hint for the item under the pointer is about to appear.
bool is_hint_due(const ViewerState& state);

/// Returns the explanation of a panel item, with its unit. A key of scenes has the text of `taut help scene`. Empty for
/// other names.
std::string hint_for(const std::string& name);
/// Hints for the panel's own items, by name (assets/texts/hints.toml).
extern const char* const hint_texts;

}  // namespace taut::app
