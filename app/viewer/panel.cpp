#include "app/viewer/panel.hpp"

#include <imgui.h>

#include <algorithm>

#include "app/viewer/panel_parts.hpp"

namespace taut::app {
namespace {

constexpr float panel_width_px = 320.0F;

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

}  // namespace

bool panel_fits(const WindowLayout& layout) {
  return layout.has_panel && layout.width_px > 2 * panel_width(layout) - panel_width(layout) / 2;
}

ViewArea scene_area(const WindowLayout& layout) {
  const int panel_px = panel_fits(layout) ? panel_width(layout) : 0;
  return {std::max(layout.width_px - panel_px, 1), std::max(layout.height_px, 1)};
}

void lay_out(ViewerState& state, const WindowLayout& layout) {
  state.places.clear();
  const ViewArea area = scene_area(layout);
  lay_out_legends(state, layout.scale);
  if (panel_fits(layout)) {
    lay_out_panel(state, layout, area);
  }
  if (layout.has_panel) {
    lay_out_time_bar(state, area, layout.scale);
  }
  lay_out_messages(state, area, layout.scale);
  lay_out_key_sheet(state, area);
}

void note_place(ViewerState& state, const char* name) {
  const ImVec2 lower = ImGui::GetItemRectMin();
  const ImVec2 upper = ImGui::GetItemRectMax();
  state.places[name] = {{lower.x, lower.y}, {upper.x, upper.y}};
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
                  int highest) {
  const bool changed = ImGui::SliderInt(label, &value, lowest, highest, "%d",
                                        ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
  note_place(state, name);
  return changed;
}

}  // namespace taut::app
