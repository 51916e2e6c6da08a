#include <imgui.h>

#include "app/viewer/panel/panel_parts.hpp"

namespace taut::app {
namespace {

// The two wind values of the paper's figure 5. The slider snaps to them.
constexpr std::array<double, 2> paper_values = {1.0, 10.0};
// Distance within which it snaps. A larger value makes nearby speeds unreachable.
constexpr double snap_m_per_s = 0.12;

struct Colours {
  ImU32 track = ImGui::GetColorU32(ImGuiCol_FrameBg);
  ImU32 filled = ImGui::GetColorU32(ImGuiCol_SliderGrabActive);
  ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
  ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  ImU32 knob = IM_COL32(255, 255, 255, 255);
  ImU32 mark = IM_COL32(192, 57, 43, 255);
};

double snapped(double speed) {
  for (const double value : paper_values) {
    if (std::abs(speed - value) < snap_m_per_s) return value;
  }
  return std::round(speed * 100.0) / 100.0;
}

void draw_scale(ImDrawList& list, const Colours& colours, const ImVec2& left, float width, float scale) {
  const auto x_of = [&](double speed) {
    return left.x + width * static_cast<float>(speed / strongest_wind_m_per_s);
  };
  for (int speed = 5; speed <= 20; speed += 5) {
    if (speed == 10) continue;
    const std::string text = std::to_string(speed);
    const float x = x_of(speed);
    list.AddLine({x, left.y}, {x, left.y + 4.0F * scale}, colours.faint, scale);
    list.AddText({x - 0.5F * ImGui::CalcTextSize(text.c_str()).x, left.y + 5.0F * scale}, colours.faint,
                 text.c_str());
  }
  for (const double speed : paper_values) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "%.1f", speed);
    const float x = x_of(speed);
    list.AddTriangleFilled({x, left.y}, {x + 4.0F * scale, left.y + 7.0F * scale},
                           {x - 4.0F * scale, left.y + 7.0F * scale}, colours.mark);
    list.AddText({x - 0.5F * ImGui::CalcTextSize(text.data()).x, left.y + 7.0F * scale}, colours.mark,
                 text.data());
  }
}

// A slider as large as its importance.
void speed_slider(ViewerState& state, float scale) {
  double& speed = state.scene.surroundings.forces.wind.speed_m_per_s;
  const float knob = 11.0F * scale;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::InvisibleButton("speed", {width, 2.0F * knob});
  note_place(state, "wind.speed");
  // Named so that 0 and 1 across are the slider's ends.
  state.places["wind.speed"] = {{corner.x + knob, corner.y},
                                {corner.x + width - knob, corner.y + 2.0F * knob}};
  const ImVec2 left = {corner.x + knob, corner.y + knob};
  const float length = width - 2.0F * knob;
  if (ImGui::IsItemActive()) {
    const double place = std::clamp((ImGui::GetIO().MousePos.x - left.x) / length, 0.0F, 1.0F);
    speed = snapped(place * strongest_wind_m_per_s);
  }

  const Colours colours;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float thick = 4.0F * scale;
  const float x = left.x + length * static_cast<float>(std::min(speed / strongest_wind_m_per_s, 1.0));
  list.AddRectFilled({left.x, left.y - thick}, {left.x + length, left.y + thick}, colours.track, thick);
  list.AddRectFilled({left.x, left.y - thick}, {x, left.y + thick}, colours.filled, thick);
  list.AddCircleFilled({x, left.y}, knob, colours.filled, 32);
  list.AddCircleFilled({x, left.y}, ImGui::IsItemActive() ? 0.55F * knob : 0.4F * knob, colours.knob, 32);
  draw_scale(list, colours, {left.x, left.y + knob + scale}, length, scale);
  ImGui::Dummy({width, ImGui::GetTextLineHeight() + 4.0F * scale});
}

// Directions on the ground as the camera sees them: up on the dial is away from the eye.
struct Ground {
  glm::dvec3 away;
  glm::dvec3 right;

  explicit Ground(double azimuth_rad)
      : away(-std::sin(azimuth_rad), 0.0, -std::cos(azimuth_rad)),
        right(std::cos(azimuth_rad), 0.0, -std::sin(azimuth_rad)) {}
};

void direction_dial(ViewerState& state, float radius, float scale) {
  glm::dvec3& direction = state.scene.surroundings.forces.wind.direction;
  const Ground ground(state.camera.azimuth_rad());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("direction", {2.0F * radius, 2.0F * radius});
  note_place(state, "wind.direction");
  const ImVec2 centre = {corner.x + radius, corner.y + radius};
  const ImVec2 pointer = {ImGui::GetIO().MousePos.x - centre.x, ImGui::GetIO().MousePos.y - centre.y};
  if (ImGui::IsItemActive() && (pointer.x != 0.0F || pointer.y != 0.0F)) {
    // Wind that also rises or falls keeps doing so.
    const double flat = std::max(std::hypot(direction.x, direction.z), 1e-3);
    const glm::dvec3 asked =
        static_cast<double>(pointer.x) * ground.right - static_cast<double>(pointer.y) * ground.away;
    direction = glm::normalize(asked) * flat + glm::dvec3(0.0, direction.y, 0.0);
  }

  const Colours colours;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto across = static_cast<float>(glm::dot(direction, ground.right));
  const auto along = static_cast<float>(glm::dot(direction, ground.away));
  const float length = std::max(std::hypot(across, along), 1e-6F);
  const ImVec2 unit = {across / length, -along / length};
  const float reach = 0.78F * radius;
  const ImVec2 tip = {centre.x + reach * unit.x, centre.y + reach * unit.y};
  const ImVec2 tail = {centre.x - reach * unit.x, centre.y - reach * unit.y};
  const ImVec2 neck = {tip.x - 10.0F * scale * unit.x, tip.y - 10.0F * scale * unit.y};
  list.AddCircleFilled(centre, radius, colours.track, 48);
  list.AddCircle(centre, radius, colours.faint, 48, scale);
  list.AddLine(tail, neck, colours.filled, 4.0F * scale);
  list.AddTriangleFilled(tip, {neck.x - 7.0F * scale * unit.y, neck.y + 7.0F * scale * unit.x},
                         {neck.x + 7.0F * scale * unit.y, neck.y - 7.0F * scale * unit.x}, colours.filled);
}

void gust_and_gravity(ViewerState& state) {
  sim::ExternalForces& forces = state.scene.surroundings.forces;
  sim::Wind& wind = forces.wind;
  ImGui::PushItemWidth(-0.38F * ImGui::GetContentRegionAvail().x);
  number_slider(state, "gusts", "wind.gust_amplitude", wind.gust_amplitude, 0.0, 1.0, "%.2f");
  number_slider(state, "period", "wind.gust_period", wind.gust_period_s, 0.1, 10.0, "%.1f s", true);
  double down = 0.0 - forces.gravity_m_per_s2.y;  // and not -0
  if (number_slider(state, "gravity", "gravity", down, 0.0, 20.0, "%.2f m/s²")) {
    forces.gravity_m_per_s2.y = -down;
  }
  ImGui::PopItemWidth();
}

}  // namespace

void lay_out_wind(ViewerState& state, float scale) {
  const double speed = state.scene.surroundings.forces.wind.speed_m_per_s;
  ImGui::Text("Wind  %.1f m/s", speed);
  ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize("H: keys").x);
  ImGui::TextDisabled("H: keys");
  speed_slider(state, scale);
  const float radius = 1.5F * ImGui::GetFrameHeightWithSpacing() - 0.5F * ImGui::GetStyle().ItemSpacing.y;
  direction_dial(state, radius, scale);
  ImGui::SameLine();
  ImGui::BeginGroup();
  gust_and_gravity(state);
  ImGui::EndGroup();
}

}  // namespace taut::app
