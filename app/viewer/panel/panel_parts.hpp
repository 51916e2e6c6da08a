#pragma once

#include <imgui.h>

#include "app/viewer/panel/panel.hpp"

namespace taut::app {

/// Flags of ImGui windows over the scene.
constexpr ImGuiWindowFlags over_scene = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                        ImGuiWindowFlags_NoFocusOnAppearing;
constexpr ImGuiWindowFlags untouchable = over_scene | ImGuiWindowFlags_NoInputs;

// Functions that draw parts of the user interface. Call them between begin_frame and end_frame of UserInterface.

void lay_out_wind(ViewerState& state, float scale);
void lay_out_measurements(ViewerState& state, float scale);
void lay_out_looks(ViewerState& state);
void lay_out_choices(ViewerState& state);
void lay_out_keeping(ViewerState& state);
void lay_out_time_bar(ViewerState& state, const ViewArea& area, float scale);
void lay_out_messages(const ViewerState& state, const ViewArea& area, float scale);
void lay_out_key_sheet(ViewerState& state, const ViewArea& area);
/// Draws the legends for the colours on the cloth.
void lay_out_legends(const ViewerState& state, float scale);
/// Draws the list of solvers for a second garment beside the first.
void lay_out_comparison(ViewerState& state);
/// Draws name, stretch and cost of each of two garments. `area` is the first one's.
void lay_out_labels(const ViewerState& state, const ViewArea& area, float scale);
/// Returns milliseconds as a short text.
std::string few_digits(float milliseconds);

/// Stores the rectangle of the last item under this name. Shows its hint if the pointer rests on it.
void note_place(ViewerState& state, const char* name);
/// Entry of a list.
struct ListEntry {
  std::string label;
  std::string name;  ///< the entry is stored as LIST.NAME (note_place)
  bool is_chosen = false;
  std::optional<std::size_t> thumbnail = std::nullopt;  ///< index of its thumbnail in UserInterface
};
/// Draws a list, which shows `closed` while it is closed; Escape closes it. Returns the index of a clicked entry.
std::optional<std::size_t> draw_list(ViewerState& state, const char* label, const std::string& name,
                                     const std::string& closed, const std::vector<ListEntry>& entries);
/// Draws a list of kinds. `closed` is shown instead of the chosen kind.
template <class Kinds, class Kind>
void kind_list(ViewerState& state, const char* label, const char* name, const Kinds& kinds, Kind& chosen,
               const char* closed = nullptr) {
  std::vector<ListEntry> entries;
  for (const Kind kind : kinds) entries.push_back({to_name(kind), to_name(kind), kind == chosen});
  if (const auto clicked = draw_list(state, label, name, closed != nullptr ? closed : to_name(chosen), entries)) {
    chosen = kinds[*clicked];
  }
}
/// Draws a button that requests an action.
void action_button(ViewerState& state, const char* label, Action action, const char* name, float width_px = 0.0F);
/// Slider for a number of the scene.
struct Slider {
  const char* label;
  const char* name;  ///< key of the scene
  double& value;
  double lowest;
  double highest;
  const char* format;
  bool logarithmic = false;
};
/// Draws the slider. Returns true if the user changed the number.
bool number_slider(ViewerState& state, const Slider& slider);
/// Draws a slider for a whole number, as number_slider does.
bool whole_slider(ViewerState& state, const char* label, const char* name, int& value, int lowest, int highest,
                  const char* format = "%d");

}  // namespace taut::app
