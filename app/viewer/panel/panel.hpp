#pragma once

#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// A window, in pixels, and how much larger than usual things are drawn.
struct WindowLayout {
  int width_px = 0;
  int height_px = 0;
  float scale = 1.0F;
  bool has_panel = true;
};

/// The panel has no background of its own: a quarter of a million pixels that need no shader.
inline constexpr float behind_panel_grey = 0.965F;

/// What the panel leaves for the scene. A window too narrow for both has no panel.
ViewArea scene_area(const WindowLayout& layout);
bool panel_fits(const WindowLayout& layout);

/// Lays everything out that is not the scene itself, between begin_frame and end_frame of UserInterface;
/// changes the state's settings as a person does and notes what else was asked for.
void lay_out(ViewerState& state, const WindowLayout& layout);

/// Whether what the pointer rests on is about to be explained.
bool is_hint_due(const ViewerState& state);

}  // namespace taut::app
