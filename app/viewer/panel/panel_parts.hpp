#pragma once

#include <imgui.h>

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
/// An entry of a list.
struct ListEntry {
  std::string label;
  std::string name;  ///< it is placed at the name of the list, a full stop and this
  bool is_chosen = false;
  std::optional<std::size_t> thumbnail = std::nullopt;  ///< its number among those of UserInterface
};
/// A list, which shows `closed` while it is not open; Escape closes it. Returns the number of the entry that
/// was clicked.
std::optional<std::size_t> list_of(ViewerState& state, const char* label, const std::string& name,
                                   const std::string& closed, const std::vector<ListEntry>& entries);
/// A list of the kinds. `closed` is shown instead of the one that is chosen.
template <class Kinds, class Kind>
void kind_list(ViewerState& state, const char* label, const char* name, const Kinds& kinds, Kind& chosen,
               const char* closed = nullptr) {
  std::vector<ListEntry> entries;
  for (const Kind kind : kinds) entries.push_back({name_of(kind), name_of(kind), kind == chosen});
  if (const auto clicked = list_of(state, label, name, closed != nullptr ? closed : name_of(chosen), entries)) {
    chosen = kinds[*clicked];
  }
}
/// A button that asks for an action.
void action_button(ViewerState& state, const char* label, Action action, const char* name, float width_px = 0.0F);
/// A slider for a number of the scene.
struct Slider {
  const char* label;
  const char* name;  ///< the key
  double& value;
  double lowest;
  double highest;
  const char* format;
  bool logarithmic = false;
};
/// Returns whether the user changed it.
bool number_slider(ViewerState& state, const Slider& slider);
/// As number_slider, for whole numbers.
bool whole_slider(ViewerState& state, const char* label, const char* name, int& value, int lowest, int highest,
                  const char* format = "%d");

}  // namespace taut::app
