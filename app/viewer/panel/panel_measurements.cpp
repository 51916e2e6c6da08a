#include <fmt/core.h>

#include "app/base/words.hpp"
#include "app/drawing/spring_lines.hpp"
#include "app/scene/scene.hpp"
#include "app/viewer/panel/panel_parts.hpp"
#include "app/viewer/panel/user_interface.hpp"
#include "app/viewer/state/viewer_state.hpp"

// Measurements, and overlays of the scene: the time bar, messages, legends and the list of keys.

namespace taut::app {
namespace {

constexpr ImU32 curve_colour = IM_COL32(63, 111, 168, 255);
constexpr ImU32 second_colour = IM_COL32(201, 126, 42, 255);
constexpr ImU32 bound_colour = IM_COL32(192, 57, 43, 255);

struct Words {
  std::string text;
  ImU32 colour = ImGui::GetColorU32(ImGuiCol_TextDisabled);
};

struct PanelPlot {
  std::string title;
  std::vector<Words> reading;  ///< newest values; several have the colours of their curves
};

// Draws the frame of a plot with its title and newest values above. Returns the rectangle for the curves.
ItemPlace plot_frame(ViewerState& state, const char* name, const PanelPlot& plot, float scale) {
  ImGui::BeginGroup();
  ImGui::TextUnformatted(plot.title.c_str());
  const float width = ImGui::GetContentRegionAvail().x;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  float left = width + gap;  // offset from the group's left edge
  for (const Words& words : plot.reading) left -= ImGui::CalcTextSize(words.text.c_str()).x + gap;
  for (const Words& words : plot.reading) {
    ImGui::SameLine(left);
    ImGui::PushStyleColor(ImGuiCol_Text, words.colour);
    ImGui::TextUnformatted(words.text.c_str());
    ImGui::PopStyleColor();
    left += ImGui::CalcTextSize(words.text.c_str()).x + gap;
  }
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = 15.0F * scale;
  ImGui::Dummy({width, height});
  ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + width, corner.y + height},
                                            ImGui::GetColorU32(ImGuiCol_FrameBg), 3.0F * scale);
  ImGui::EndGroup();
  note_place(state, name);
  return {{corner.x, corner.y}, {corner.x + width, corner.y + height}};
}

float plot_height(float value, const ItemPlace& place, float highest) {
  const float part = std::clamp(value / highest, 0.0F, 1.0F);
  return place.upper_px.y - 1.0F - part * (place.upper_px.y - place.lower_px.y - 2.0F);
}

// Writes the upper end of a plot's scale at its left end. Returns the rectangle that is left for the curves.
ItemPlace draw_plot_top(ItemPlace place, const std::string& text) {
  ImGui::GetWindowDrawList()->AddText({place.lower_px.x + 3.0F, place.lower_px.y},
                                      ImGui::GetColorU32(ImGuiCol_TextDisabled), text.c_str());
  place.lower_px.x += 4.0F * ImGui::GetFontSize();
  return place;
}

void draw_curve(std::span<const float> values, const ItemPlace& place, float highest, ImU32 colour, float scale) {
  if (values.size() < 2) return;
  const float step = (place.upper_px.x - place.lower_px.x) / static_cast<float>(RecentValues::max_count - 1);
  std::vector<ImVec2> points;
  points.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto from_end = static_cast<float>(values.size() - 1 - i);
    points.emplace_back(place.upper_px.x - step * from_end, plot_height(values[i], place, highest));
  }
  // A whole number of pixels needs two triangles per point instead of six.
  ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), colour, ImDrawFlags_None,
                                          std::round(1.5F * scale));
}

float max_value(std::span<const float> values) { return values.empty() ? 0.0F : *std::ranges::max_element(values); }

// Returns the value that 95 of 100 do not exceed. Few frames take much longer than all others.
float usual_value(std::span<const float> values) {
  std::vector<float> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  return sorted.empty() ? 0.0F : sorted[sorted.size() * 95 / 100];
}

// Returns the maximum of a scale, 1, 2 or 5 times a power of 10, so that the scale does not change with every value.
float rounded_up(float value, float least) {
  const float limit = std::max(value, least), power = std::pow(10.0F, std::floor(std::log10(limit)));
  for (const float step : {1.0F, 2.0F, 5.0F}) {
    if (limit <= 1.0001F * step * power) return step * power;
  }
  return 10.0F * power;
}

// Draws a line as wide as the panel, so that the pointer stays over it when the text becomes shorter.
void reading_line(ViewerState& state, const char* name, const std::string& text) {
  ImGui::BeginGroup();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::TextDisabled("%s", text.c_str());
  ImGui::SameLine(0.0F, 0.0F);
  ImGui::Dummy({std::max(width - ImGui::CalcTextSize(text.c_str()).x, 0.0F), 0.0F});
  ImGui::EndGroup();
  note_place(state, name);
}

void plot_stretch(ViewerState& state, float scale) {
  const sim::BoundKind kind_kept = bound_kind(state.scene);
  const bool holds_springs = kind_kept == sim::BoundKind::springs;
  const RecentValues& stretch = holds_springs ? state.measurements.max_stretch : state.measurements.max_surface_stretch;
  const std::optional<double> bound = stretch_bound(state.scene);
  const auto limit = static_cast<float>(bound.value_or(0.0));
  const std::string now = short_number(100.0F * stretch.last(), 2);
  const std::string reading =
      bound ? fmt::format("{} %, {} {:.4g} %", now, bound_word(state.scene), 100.0 * *bound) : now + " %, no bound";
  const float highest = rounded_up(max_value(stretch.values()), std::max(1.25F * limit, 0.001F));
  const bool is_exceeded = bound && !state.newest->record.bound_kept;
  const Words words = is_exceeded ? Words{reading, bound_colour} : Words{reading};
  const ItemPlace frame = plot_frame(state, "measured.stretch",
                                     {holds_springs ? "Stretch of springs" : "Stretch of the surface", {words}}, scale);
  const ItemPlace place = draw_plot_top(frame, fmt::format("{:.3g} %", 100.0F * highest));
  if (bound) {
    const float y = plot_height(limit, place, highest);
    ImGui::GetWindowDrawList()->AddLine({place.lower_px.x, y}, {place.upper_px.x, y}, bound_colour, scale);
  }
  draw_curve(stretch.values(), place, highest, curve_colour, scale);
  reading_line(state, "measured.stretches", other_stretches(state.newest->record, kind_kept));
  reading_line(state, "measured.contact", contact_text(state.newest->record.contact));
}

void plot_convergence(ViewerState& state, float scale) {
  const RecentValues& moved = state.measurements.convergence_mm;
  const float highest = rounded_up(max_value(moved.values()), 0.01F);
  const ItemPlace frame = plot_frame(state, "measured.convergence",
                                     {"Largest movement", {{short_number(moved.last(), 2) + " mm a frame"}}}, scale);
  draw_curve(moved.values(), draw_plot_top(frame, fmt::format("{:.3g} mm", highest)), highest, curve_colour, scale);
}

void plot_times(ViewerState& state, float scale) {
  const Measurements& m = state.measurements;
  if (!m.shows_times) {
    plot_frame(state, "measured.times", {"Milliseconds", {{"not shown here"}}}, scale);
    return;
  }
  const float usual_ms = std::max(usual_value(m.simulate_ms.values()), usual_value(m.draw_ms.values()));
  const float highest = rounded_up(usual_ms, 10.0F);
  const std::vector<Words> reading = {{"simulate " + few_digits(m.simulate_ms.last()), curve_colour},
                                      {"draw " + few_digits(m.draw_ms.last()), second_colour},
                                      {"panel " + few_digits(m.panel_ms.last())}};
  const ItemPlace frame = plot_frame(state, "measured.times", {"Milliseconds", reading}, scale);
  const ItemPlace place = draw_plot_top(frame, fmt::format("{:.0f} ms", highest));
  draw_curve(m.simulate_ms.values(), place, highest, curve_colour, scale);
  draw_curve(m.draw_ms.values(), place, highest, second_colour, scale);
}

std::string size_text(const sim::Garment& garment) {
  return fmt::format("{} triangles, {} vertices", garment.mesh.triangles.size(), garment.mesh.positions.size());
}

std::string reason_text(SlowedBy reason, const Snapshot& newest) {
  constexpr std::array texts = {"", ", slowed by the simulation", ", slowed by drawing", ", slowed by other programs"};
  if (reason == SlowedBy::simulation && newest.compared) return std::string(", slowed by ") + slower_solver(newest);
  return texts[static_cast<std::size_t>(reason)];
}

/// Returns the simulation's speed and the reason why it is not faster; empty if it is unknown.
std::optional<std::pair<double, SlowedBy>> simulation_speed(const ViewerState& state) {
  const Measurements& m = state.measurements;
  const auto factor = m.real_time.factor();
  if (!m.shows_times || !factor) return std::nullopt;
  const double frame_ms = 1000.0 / (state.scene.simulation.frame_rate_hz * state.speed);
  return std::pair(*factor, find_slowdown(*factor, state.speed, m.worked_ms, frame_ms, m.real_time.busy_share()));
}

std::string pictures_text(const ViewerState& state) {
  const Measurements& m = state.measurements;
  return m.shows_times && m.real_time.factor()
             ? count_text(std::lround(m.real_time.pictures_per_s()), "picture") + " a second"
             : "pictures a second: not known here";
}

bool stands_still(const ViewerState& state) { return state.newest->paused || has_stopped(*state.newest); }

std::string speed_text(const ViewerState& state) {
  if (stands_still(state)) return state.newest->paused ? "paused" : "stopped";
  const auto speed = simulation_speed(state);
  if (!speed) return "times real time: not known here";
  return fmt::format("{:.2f} x real time{}", speed->first, reason_text(speed->second, *state.newest));
}

constexpr float background = 0.88F;

constexpr std::array<std::pair<const char*, double>, 4> speeds = {
    {{"1 x", 1.0}, {"1/2", 0.5}, {"1/4", 0.25}, {"1/10", 0.1}}};

ImU32 pack_colour(const renderer::Colour& colour) {
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
  if (const auto clicked = draw_list(state, "##speed", "speed", shown, entries)) state.speed = speeds[*clicked].second;
}

void lay_out_timeline(ViewerState& state, float width) {
  const Snapshot& newest = *state.newest;
  // Floating-point values make the knob narrow; with integers it would be as wide as one frame of a few.
  const double last = newest.record.frame;
  const double first = std::min<double>(first_frame_in_reach(newest), last - 1.0);
  double place = state.past_frame.value_or(newest.record.frame);
  const double behind_s = (last - place) / newest.loaded->scene.simulation.frame_rate_hz;
  const std::string text = behind_s > 0.0 ? fmt::format("{:.2f} s ago", behind_s) : std::string("now");
  ImGui::SetNextItemWidth(width);
  if (ImGui::SliderScalar("##timeline", ImGuiDataType_Double, &place, &first, &last, text.c_str(),
                          ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat)) {
    const int frame = std::max(0, static_cast<int>(std::lround(place)));
    state.past_frame = frame < newest.record.frame ? std::optional(frame) : std::nullopt;
    if (state.past_frame && !state.paused) state.asked.push_back(Action::pause);
  }
  note_place(state, "timeline");
}

void legend_of_stretch(const ViewerState& state, float scale) {
  // Clang before 16 does not let a lambda capture a structured binding.
  const std::array<double, 2> range = shown_stretch_range(state.scene);
  const double low = range[0], high = range[1];
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size = {14.0F * scale, 170.0F * scale};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr int bands = 64;
  for (int i = 0; i < bands; ++i) {
    const float top = corner.y + size.y * static_cast<float>(i) / bands;
    const float t = 1.0F - (static_cast<float>(i) + 0.5F) / bands;
    list.AddRectFilled({corner.x, top}, {corner.x + size.x, top + size.y / bands + 1.0F},
                       pack_colour(renderer::colour_at(renderer::ColourMap::viridis, t)));
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
    mark(*bound, fmt::format("{:.4g} % {}", 100.0 * *bound, bound_word(state.scene)), IM_COL32(192, 57, 43, 255));
  }
  ImGui::Dummy({size.x + ImGui::CalcTextSize("00.00 % and more").x + 12.0F * scale, size.y + 6.0F * scale});
}

void legend_of_springs(const ViewerState& state, float scale) {
  for (const sim::SpringKind kind : sim::all_spring_kinds) {
    if (!shows(state.scene.picture.springs, kind)) continue;
    const std::size_t count = state.newest->loaded->garment->springs.count(kind);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float y = corner.y + 0.5F * ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddLine({corner.x, y}, {corner.x + 16.0F * scale, y}, pack_colour(spring_colour(kind)),
                                        3.0F * scale);
    ImGui::Dummy({18.0F * scale, ImGui::GetTextLineHeight()});
    ImGui::SameLine();
    ImGui::Text("%s, %zu", sim::to_name(kind), count);
  }
}

}  // namespace

std::string few_digits(float milliseconds) {
  return fmt::format("{:.{}f}", milliseconds, milliseconds < 10.0F ? 1 : 0);
}

void lay_out_measurements(ViewerState& state, float scale) {
  ImGui::Separator();
  plot_stretch(state, scale);
  plot_convergence(state, scale);
  plot_times(state, scale);
  reading_line(state, "measured.pictures", pictures_text(state));
  reading_line(state, "measured.size", size_text(*state.newest->loaded->garment));
  reading_line(state, "measured.speed", speed_text(state));
}

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
    const float room =
        ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize("0000.00 s").x - ImGui::GetStyle().ItemSpacing.x;
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
  ImGui::SetNextWindowPos({0.5F * width, static_cast<float>(area.height_px) - bar}, ImGuiCond_Always, {0.5F, 1.0F});
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {std::max(width - 16.0F * scale, 32.0F), 1e6F});
  ImGui::SetNextWindowBgAlpha(background);
  if (ImGui::Begin("messages", nullptr, untouchable)) {
    ImGui::PushTextWrapPos(std::max(std::min(640.0F * scale, width - 48.0F * scale), 16.0F));
    if (!state.warning.empty()) ImGui::TextUnformatted(state.warning.c_str());
    for (const Message& message : state.messages) {
      const ImVec4 ink = message.is_error ? ImVec4(0.70F, 0.12F, 0.10F, 1.0F) : ImGui::GetStyleColorVec4(ImGuiCol_Text);
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
  ImGui::SetNextWindowPos({0.5F * static_cast<float>(area.width_px), 0.45F * static_cast<float>(area.height_px)},
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

void lay_out_legends(const ViewerState& state, float scale) {
  const bool stretch = state.scene.picture.surface == SurfaceLook::stretch;
  const bool springs = state.scene.picture.springs != WhichSprings::none;
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
