#pragma once

#include <imgui.h>

#include <string>

#include "app/viewer/panel/panel.hpp"

namespace taut::app {

/// Of what lies over the scene.
constexpr ImGuiWindowFlags over_scene = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                        ImGuiWindowFlags_NoFocusOnAppearing;
constexpr ImGuiWindowFlags untouchable = over_scene | ImGuiWindowFlags_NoInputs;

// The parts of the user interface; each between begin_frame and end_frame of UserInterface.

void lay_out_wind(ViewerState& state, float scale);
void lay_out_measurements(ViewerState& state, float scale);
void lay_out_looks(ViewerState& state);
void lay_out_choices(ViewerState& state);
void lay_out_keeping(ViewerState& state);
void lay_out_time_bar(ViewerState& state, const ViewArea& area, float scale);
void lay_out_messages(const ViewerState& state, const ViewArea& area, float scale);
void lay_out_key_sheet(ViewerState& state, const ViewArea& area);
/// The legends that explain the colours on the cloth.
void lay_out_legends(const ViewerState& state, float scale);
/// The list of solvers that a second garment can have beside the first.
void lay_out_comparison(ViewerState& state);
/// Name, stretch and cost of each of two garments; `area` is of the first one.
void lay_out_labels(const ViewerState& state, const ViewArea& area, float scale);
/// Milliseconds as text of few letters.
std::string few_digits(float milliseconds);

/// Notes the rectangle of the last item under this name. Shows its hint if the pointer rests on it.
void note_place(ViewerState& state, const char* name);
/// Begins a list of choices. If it returns true the list is open and ImGui::EndCombo must be called. Escape
/// closes it.
bool begin_list(const char* label, const char* chosen);
/// A list of the kinds; each entry is placed at the name of the list, a full stop and its own name. `closed`
/// is shown instead of the one that is chosen.
template <class Kinds, class Kind>
void kind_list(ViewerState& state, const char* label, const char* name, const Kinds& kinds, Kind& chosen,
               const char* closed = nullptr) {
  if (begin_list(label, closed != nullptr ? closed : name_of(chosen))) {
    for (const Kind kind : kinds) {
      if (ImGui::Selectable(name_of(kind), kind == chosen)) {
        chosen = kind;
      }
      note_place(state, (std::string(name) + '.' + name_of(kind)).c_str());
    }
    ImGui::EndCombo();
  }
  note_place(state, name);
}
/// A button that asks for an action.
void action_button(ViewerState& state, const char* label, Action action, const char* name,
                   float width_px = 0.0F);
/// A slider for a number of the scene; `name` is its key. Returns whether the user changed it.
bool number_slider(ViewerState& state, const char* label, const char* name, double& value, double lowest,
                   double highest, const char* format, bool logarithmic = false);
/// As number_slider, for whole numbers.
bool whole_slider(ViewerState& state, const char* label, const char* name, int& value, int lowest,
                  int highest, const char* format = "%d");

}  // namespace taut::app
