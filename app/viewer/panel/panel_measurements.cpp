#include <fmt/core.h>
#include <imgui.h>

#include "app/scene/scene.hpp"
#include "app/viewer/panel/panel_parts.hpp"

namespace taut::app {
namespace {

constexpr ImU32 curve_colour = IM_COL32(63, 111, 168, 255);
constexpr ImU32 second_colour = IM_COL32(201, 126, 42, 255);
constexpr ImU32 bound_colour = IM_COL32(192, 57, 43, 255);

struct Words {
  std::string text;
  ImU32 colour = ImGui::GetColorU32(ImGuiCol_TextDisabled);
};

struct Plot {
  std::string title;
  std::vector<Words> reading;  ///< the newest values; in the colours of their curves where there are several
};

// The frame of a plot with its line of text above; returns the rectangle for the curves.
ItemPlace plot_frame(ViewerState& state, const char* name, const Plot& plot, float scale) {
  ImGui::BeginGroup();
  ImGui::TextUnformatted(plot.title.c_str());
  const float width = ImGui::GetContentRegionAvail().x;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  float left = width + gap;  // from where the group begins
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

float height_of(float value, const ItemPlace& place, float highest) {
  const float part = std::clamp(value / highest, 0.0F, 1.0F);
  return place.upper_px.y - 1.0F - part * (place.upper_px.y - place.lower_px.y - 2.0F);
}

void draw_curve(std::span<const float> values, const ItemPlace& place, float highest, ImU32 colour,
                float scale) {
  if (values.size() < 2) return;
  const float step = (place.upper_px.x - place.lower_px.x) / static_cast<float>(RecentValues::most - 1);
  std::vector<ImVec2> points;
  points.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto from_end = static_cast<float>(values.size() - 1 - i);
    points.emplace_back(place.upper_px.x - step * from_end, height_of(values[i], place, highest));
  }
  // Of a whole number of pixels: two triangles for each point instead of six.
  ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), colour,
                                          ImDrawFlags_None, std::round(1.5F * scale));
}

float largest(std::span<const float> values) {
  return values.empty() ? 0.0F : *std::ranges::max_element(values);
}

// Scales in steps, or they would breathe with every value.
float rounded_up(float value, float least) {
  float limit = least;
  while (limit < value) limit *= 2.0F;
  return limit;
}

// As wide as the panel: a line whose end comes and goes would take its explanation from under the pointer.
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
  const sim::BoundKind held = bound_kind(state.scene);
  const bool holds_springs = held == sim::BoundKind::springs;
  const RecentValues& stretch =
      holds_springs ? state.measurements.max_stretch : state.measurements.max_surface_stretch;
  const std::optional<double> bound = stretch_bound(state.scene);
  const auto limit = static_cast<float>(bound.value_or(0.0));
  const std::string now = in_little_room(100.0F * stretch.last(), 2);
  const std::string reading =
      bound ? fmt::format("{} %, {} {:.4g} %", now, bound_word(state.scene), 100.0 * *bound)
            : now + " %, no bound";
  const float highest = rounded_up(largest(stretch.values()), std::max(1.25F * limit, 0.001F));
  const bool is_exceeded = bound && !state.newest->record.bound_kept;
  const Words words = is_exceeded ? Words{reading, bound_colour} : Words{reading};
  const ItemPlace place =
      plot_frame(state, "measured.stretch",
                 {holds_springs ? "Stretch of springs" : "Stretch of the surface", {words}}, scale);
  if (bound) {
    const float y = height_of(limit, place, highest);
    ImGui::GetWindowDrawList()->AddLine({place.lower_px.x, y}, {place.upper_px.x, y}, bound_colour, scale);
  }
  draw_curve(stretch.values(), place, highest, curve_colour, scale);
  reading_line(state, "measured.stretches", other_stretches(state.newest->record, held));
  reading_line(state, "measured.contact", contact_text(state.newest->record.contact));
}

void plot_convergence(ViewerState& state, float scale) {
  const RecentValues& moved = state.measurements.convergence_mm;
  const float highest = rounded_up(largest(moved.values()), 0.01F);
  const ItemPlace place =
      plot_frame(state, "measured.convergence",
                 {"Convergence", {{in_little_room(moved.last(), 3) + " mm a frame"}}}, scale);
  draw_curve(moved.values(), place, highest, curve_colour, scale);
}

void plot_times(ViewerState& state, float scale) {
  const Measurements& m = state.measurements;
  if (!m.shows_times) {
    plot_frame(state, "measured.times", {"Milliseconds", {{"not shown here"}}}, scale);
    return;
  }
  const float highest =
      rounded_up(std::max(largest(m.simulate_ms.values()), largest(m.draw_ms.values())), 10.0F);
  const std::vector<Words> reading = {{"simulate " + few_digits(m.simulate_ms.last()), curve_colour},
                                      {"draw " + few_digits(m.draw_ms.last()), second_colour},
                                      {"panel " + few_digits(m.panel_ms.last())}};
  const ItemPlace place = plot_frame(state, "measured.times", {"ms", reading}, scale);
  draw_curve(m.simulate_ms.values(), place, highest, curve_colour, scale);
  draw_curve(m.draw_ms.values(), place, highest, second_colour, scale);
}

std::string size_text(const sim::Garment& garment) {
  return fmt::format("{} triangles, {} vertices", garment.mesh.triangles.size(),
                     garment.mesh.positions.size());
}

std::string reason_text(SlowedBy reason, const Snapshot& newest) {
  constexpr std::array texts = {"", ", slowed by the simulation", ", slowed by drawing",
                                ", slowed by other programs"};
  if (reason == SlowedBy::simulation && newest.compared) {
    return std::string(", slowed by ") + slower_solver(newest);
  }
  return texts[static_cast<std::size_t>(reason)];
}

std::string speed_text(const ViewerState& state) {
  const Measurements& m = state.measurements;
  if (state.newest->paused || has_stopped(*state.newest)) return state.newest->paused ? "paused" : "stopped";
  const auto factor = m.real_time.factor();
  if (!m.shows_times || !factor) return "times real time: not known here";
  const double frame_ms = 1000.0 / (state.scene.simulation.frame_rate_hz * state.speed);
  const SlowedBy reason = slowed_by(*factor, state.speed, m.worked_ms, frame_ms, m.real_time.busy_share());
  return fmt::format("{:.2f} x real time{}", *factor, reason_text(reason, *state.newest));
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
  reading_line(state, "measured.size", size_text(*state.newest->loaded->garment));
  reading_line(state, "measured.speed", speed_text(state));
}

}  // namespace taut::app
