#pragma once

#include "app/viewer/panel/panel.hpp"

namespace taut::app {

// The parts of the user interface; each between begin_frame and end_frame of UserInterface.

void lay_out_wind(ViewerState& state, float scale);
void lay_out_measurements(ViewerState& state, float scale);
void lay_out_looks(ViewerState& state);
void lay_out_choices(ViewerState& state);
void lay_out_keeping(ViewerState& state);
void lay_out_time_bar(ViewerState& state, const ViewArea& area, float scale);
void lay_out_messages(const ViewerState& state, const ViewArea& area, float scale);
void lay_out_key_sheet(ViewerState& state, const ViewArea& area);
/// What the colours on the cloth mean.
void lay_out_legends(const ViewerState& state, float scale);

/// Notes where the last thing laid out is, and explains it to a pointer that rests on it.
void note_place(ViewerState& state, const char* name);
/// A list that opens, for ImGui::EndCombo where it does; Escape closes it.
bool begin_list(const char* label, const char* chosen);
/// A button that asks for an action.
void action_button(ViewerState& state, const char* label, Action action, const char* name,
                   float width_px = 0.0F);
/// A slider over a number of the scene, noted by the number's key.
bool number_slider(ViewerState& state, const char* label, const char* name, double& value, double lowest,
                   double highest, const char* format, bool logarithmic = false);
bool whole_slider(ViewerState& state, const char* label, const char* name, int& value, int lowest,
                  int highest, const char* format = "%d");

}  // namespace taut::app
