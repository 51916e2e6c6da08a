#include <fmt/core.h>
#include <imgui.h>

#include "app/drawing/spring_lines.hpp"
#include "app/scene/scene.hpp"
#include "app/viewer/panel/panel_parts.hpp"
#include "app/viewer/panel/user_interface.hpp"
#include "app/viewer/state/viewer_state.hpp"
#include "renderer/page/colour.hpp"

// Overlays of the scene: the time bar, messages, legends and the sheet of keys.

namespace taut::app {
namespace {

constexpr float background = 0.88F;

constexpr std::array<std::pair<const char*, double>, 4> speeds = {
    {{"1 x", 1.0}, {"1/2", 0.5}, {"1/4", 0.25}, {"1/10", 0.1}}};

ImU32 packed(const renderer::Colour& colour) {
  return ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, 1.0F});
}

void lay_out_speed(ViewerState& state) {
  std::string shown = "?";
  std::vector<ListEntry> entries;
  for (const auto& [label, factor] : speeds) {
    entries.push_back({label, label, factor == state.speed});
    shown = factor == state.speed ? label : shown;
  }
  ImGui::SetNextItemWidth(4.2F * ImGui::GetFontSize());
  if (const auto clicked = list_of(state, "##speed", "speed", shown, entries)) {
    state.speed = speeds[*clicked].second;
  }
}

void lay_out_timeline(ViewerState& state, float width) {
  const Snapshot& newest = *state.newest;
  // In floating point, or the knob would be as wide as one of a few frames.
  const double last = newest.record.frame;
  const double first = std::min<double>(first_frame_in_reach(newest), last - 1.0);
  double place = state.past_frame.value_or(newest.record.frame);
  const double behind_s = (last - place) / newest.loaded->scene.simulation.frame_rate_hz;
  const std::string text = behind_s > 0.0 ? fmt::format("{:.2f} s ago", behind_s) : std::string("now");
  ImGui::SetNextItemWidth(width);
  if (ImGui::SliderScalar(
          "##timeline", ImGuiDataType_Double, &place, &first, &last, text.c_str(),
          ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat)) {
    const int frame = std::max(0, static_cast<int>(std::lround(place)));
    state.past_frame = frame < newest.record.frame ? std::optional(frame) : std::nullopt;
    if (state.past_frame && !state.paused) state.asked.push_back(Action::pause);
  }
  note_place(state, "timeline");
}

}  // namespace

void lay_out_time_bar(ViewerState& state, const ViewArea& area, float scale) {
  const auto width = static_cast<float>(area.width_px);
  ImGui::SetNextWindowPos({0.0F, static_cast<float>(area.height_px)}, ImGuiCond_Always, {0.0F, 1.0F});
  ImGui::SetNextWindowSize({width, 0.0F});
  ImGui::SetNextWindowBgAlpha(background);
  if (ImGui::Begin("time", nullptr, over_scene & ~ImGuiWindowFlags_AlwaysAutoResize)) {
    const float button = 56.0F * scale;
    action_button(state, state.paused ? "Go" : "Pause", Action::pause, "time.pause", button);
    ImGui::SameLine();
    action_button(state, "Step", Action::step, "time.step", button);
    ImGui::SameLine();
    action_button(state, "Reset", Action::reset, "time.reset", button);
    ImGui::SameLine();
    lay_out_speed(state);
    ImGui::SameLine();
    const std::string time = fmt::format("{:7.2f} s", state.shown->record.time_s);
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize("0000.00 s").x -
                       ImGui::GetStyle().ItemSpacing.x;
    lay_out_timeline(state, std::max(room, 40.0F * scale));
    ImGui::SameLine();
    ImGui::TextUnformatted(time.c_str());
  }
  ImGui::End();
}

void lay_out_messages(const ViewerState& state, const ViewArea& area, float scale) {
  if (state.messages.empty() && state.warning.empty()) return;
  const auto width = static_cast<float>(area.width_px);
  const float bar = 2.0F * ImGui::GetFrameHeightWithSpacing();
  ImGui::SetNextWindowPos({0.5F * width, static_cast<float>(area.height_px) - bar}, ImGuiCond_Always,
                          {0.5F, 1.0F});
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {std::max(width - 16.0F * scale, 32.0F), 1e6F});
  ImGui::SetNextWindowBgAlpha(background);
  if (ImGui::Begin("messages", nullptr, untouchable)) {
    ImGui::PushTextWrapPos(std::max(std::min(640.0F * scale, width - 48.0F * scale), 16.0F));
    if (!state.warning.empty()) ImGui::TextUnformatted(state.warning.c_str());
    for (const Message& message : state.messages) {
      const ImVec4 ink =
          message.is_error ? ImVec4(0.70F, 0.12F, 0.10F, 1.0F) : ImGui::GetStyleColorVec4(ImGuiCol_Text);
      ImGui::PushStyleColor(ImGuiCol_Text, ink);
      ImGui::TextUnformatted(message.text.c_str());
      ImGui::PopStyleColor();
    }
    ImGui::PopTextWrapPos();
  }
  ImGui::End();
}

void lay_out_key_sheet(ViewerState& state, const ViewArea& area) {
  if (!state.show_keys) return;
  ImGui::SetNextWindowPos(
      {0.5F * static_cast<float>(area.width_px), 0.45F * static_cast<float>(area.height_px)},
      ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowBgAlpha(0.96F);
  if (ImGui::Begin("keys", nullptr, untouchable) && ImGui::BeginTable("sheet", 2)) {
    for (const KeyBinding& binding : key_bindings()) {
      if (*binding.label == '\0') continue;
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(binding.label);
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", binding.meaning);
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

namespace {

void legend_of_stretch(const ViewerState& state, float scale) {
  // Not a structured binding, which Clang before 16 does not let a lambda capture.
  const std::array<double, 2> range = shown_stretch_range(state.scene);
  const double low = range[0];
  const double high = range[1];
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size = {14.0F * scale, 170.0F * scale};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr int bands = 64;
  for (int i = 0; i < bands; ++i) {
    const float top = corner.y + size.y * static_cast<float>(i) / bands;
    const float t = 1.0F - (static_cast<float>(i) + 0.5F) / bands;
    list.AddRectFilled({corner.x, top}, {corner.x + size.x, top + size.y / bands + 1.0F},
                       packed(renderer::colour_at(renderer::ColourMap::viridis, t)));
  }
  const auto mark = [&](double value, const std::string& text, ImU32 colour) {
    const auto part = static_cast<float>((value - low) / (high - low));
    const float y = corner.y + size.y * (1.0F - part);
    list.AddLine({corner.x, y}, {corner.x + size.x + 5.0F * scale, y}, colour, 1.5F * scale);
    list.AddText({corner.x + size.x + 8.0F * scale, y - 0.5F * ImGui::GetFontSize()}, colour, text.c_str());
  };
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
  const std::optional<double> bound = shown_bound(state.scene);
  for (int i = 0; i <= 4; ++i) {
    const double value = low + (high - low) * i / 4.0;
    const bool is_hidden = bound && std::abs(value - *bound) < 0.09 * (high - low);
    if (!is_hidden) mark(value, fmt::format("{:.4g} %{}", 100.0 * value, i == 4 ? " and more" : ""), ink);
  }
  if (bound && *bound >= low && *bound <= high) {
    mark(*bound, fmt::format("{:.4g} % {}", 100.0 * *bound, bound_word(state.scene)),
         IM_COL32(192, 57, 43, 255));
  }
  ImGui::Dummy({size.x + ImGui::CalcTextSize("00.00 % and more").x + 12.0F * scale, size.y + 6.0F * scale});
}

void legend_of_springs(const ViewerState& state, float scale) {
  for (const sim::SpringKind kind : sim::all_spring_kinds) {
    if (!shows(state.scene.picture.springs, kind)) continue;
    const std::size_t count = state.newest->loaded->garment->springs.count(kind);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float y = corner.y + 0.5F * ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddLine({corner.x, y}, {corner.x + 16.0F * scale, y},
                                        packed(spring_colour(kind)), 3.0F * scale);
    ImGui::Dummy({18.0F * scale, ImGui::GetTextLineHeight()});
    ImGui::SameLine();
    ImGui::Text("%s, %zu", sim::name_of(kind), count);
  }
}

}  // namespace

void lay_out_legends(const ViewerState& state, float scale) {
  const bool stretch = state.scene.picture.surface == SurfaceLook::stretch;
  const bool springs = state.scene.picture.springs.which != WhichSprings::none;
  if (!stretch && !springs) return;
  ImGui::SetNextWindowPos({10.0F * scale, 10.0F * scale});
  ImGui::SetNextWindowBgAlpha(0.6F);
  if (ImGui::Begin(UserInterface::in_pictures, nullptr, untouchable)) {
    if (stretch) {
      ImGui::TextUnformatted(legend_title(state.scene.picture.stretch_of));
      ImGui::Dummy({1.0F, 3.0F * scale});
      legend_of_stretch(state, scale);
    }
    if (springs) legend_of_springs(state, scale);
  }
  ImGui::End();
}

}  // namespace taut::app
