#include "app/viewer/panel/panel.hpp"

#include <imgui.h>

#include <algorithm>

#include "app/viewer/panel/panel_hints.hpp"
#include "app/viewer/panel/panel_parts.hpp"

namespace taut::app {
namespace {

// At scale 1.
constexpr float panel_width_px = 320.0F;
// The pointer must rest on an item for this long before its hint appears. A shorter time makes the panel
// flicker.
constexpr double hint_after_s = 0.5;

int panel_width(const WindowLayout& layout) {
  return static_cast<int>(panel_width_px * layout.scale);
}

void lay_out_panel(ViewerState& state, const WindowLayout& layout, const ViewArea& area) {
  ImGui::SetNextWindowPos({static_cast<float>(area.width_px), 0.0F});
  ImGui::SetNextWindowSize({static_cast<float>(panel_width(layout)), static_cast<float>(layout.height_px)});
  constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground;
  if (ImGui::Begin("panel", nullptr, fixed & ~ImGuiWindowFlags_NoScrollbar)) {
    ImGui::PushItemWidth(-0.42F * ImGui::GetContentRegionAvail().x);
    lay_out_wind(state, layout.scale);
    lay_out_measurements(state, layout.scale);
    lay_out_looks(state);
    lay_out_choices(state);
    lay_out_keeping(state);
    ImGui::PopItemWidth();
  }
  ImGui::End();
}

void explain(ViewerState& state, const std::string& name) {
  const double before_s = state.hovered && state.hovered->name == name ? state.hovered->for_s : 0.0;
  state.hovered = {name, before_s + static_cast<double>(ImGui::GetIO().DeltaTime)};
  const std::string text = hint_for(name);
  if (text.empty() || is_hint_due(state)) {
    return;
  }
  constexpr float letters_in_line = 26.0F;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(letters_in_line * ImGui::GetFontSize());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace

bool panel_fits(const WindowLayout& layout) {
  return layout.has_panel && layout.width_px > 2 * panel_width(layout) - panel_width(layout) / 2;
}

ViewArea scene_area(const WindowLayout& layout) {
  const int panel_px = panel_fits(layout) ? panel_width(layout) : 0;
  return {std::max(layout.width_px - panel_px, 1), std::max(layout.height_px, 1)};
}

ViewArea garment_area(const ViewerState& state, const WindowLayout& layout) {
  const ViewArea whole = scene_area(layout);
  return compared(state) != nullptr ? ViewArea{std::max(whole.width_px / 2, 1), whole.height_px} : whole;
}

void lay_out(ViewerState& state, const WindowLayout& layout) {
  state.places.clear();
  const std::optional<Hovered> before = state.hovered;
  const ViewArea area = scene_area(layout);
  lay_out_legends(state, layout.scale);
  lay_out_labels(state, garment_area(state, layout), layout.scale);
  if (panel_fits(layout)) {
    lay_out_panel(state, layout, area);
  }
  if (layout.has_panel) {
    lay_out_time_bar(state, area, layout.scale);
  }
  lay_out_messages(state, area, layout.scale);
  lay_out_key_sheet(state, area);
  // Nothing has been under the pointer in this frame.
  if (before && state.hovered && before->name == state.hovered->name &&
      before->for_s == state.hovered->for_s) {
    state.hovered.reset();
  }
}

void note_place(ViewerState& state, const char* name) {
  const ImVec2 lower = ImGui::GetItemRectMin();
  const ImVec2 upper = ImGui::GetItemRectMax();
  state.places[name] = {{lower.x, lower.y}, {upper.x, upper.y}};
  if (ImGui::IsItemHovered() && !ImGui::IsAnyMouseDown()) {
    explain(state, name);
  }
}

bool begin_list(const char* label, const char* chosen) {
  if (!ImGui::BeginCombo(label, chosen)) {
    return false;
  }
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    ImGui::CloseCurrentPopup();
  }
  return true;
}

bool is_hint_due(const ViewerState& state) {
  return state.hovered && state.hovered->for_s < hint_after_s;
}

void action_button(ViewerState& state, const char* label, Action action, const char* name, float width_px) {
  if (ImGui::Button(label, {width_px, 0.0F})) {
    state.asked.push_back(action);
  }
  note_place(state, name);
}

bool number_slider(ViewerState& state, const char* label, const char* name, double& value, double lowest,
                   double highest, const char* format, bool logarithmic) {
  const ImGuiSliderFlags flags =
      ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  const bool changed =
      ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &lowest, &highest, format, flags);
  note_place(state, name);
  return changed;
}

bool whole_slider(ViewerState& state, const char* label, const char* name, int& value, int lowest,
                  int highest, const char* format) {
  const bool changed = ImGui::SliderInt(label, &value, lowest, highest, format,
                                        ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
  note_place(state, name);
  return changed;
}

}  // namespace taut::app
