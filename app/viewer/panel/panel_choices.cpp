#include <fmt/core.h>

#include "app/scene/scene.hpp"
#include "app/viewer/panel/panel_parts.hpp"
#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {
namespace {

std::vector<ListEntry> make_entries(const ViewerState& state, const std::vector<Choice>& choices,
                                    const std::string& chosen) {
  std::vector<ListEntry> entries;
  for (const Choice& choice : choices) {
    entries.push_back({choice.label.empty() ? choice.name : choice.label, choice.name, choice.name == chosen});
    const auto found = std::ranges::find(state.thumbnails, choice.name);
    if (found != state.thumbnails.end()) entries.back().thumbnail = found - state.thumbnails.begin();
  }
  return entries;
}

void lay_out_scene_list(ViewerState& state) {
  const std::string& name = state.scene.name;
  if (const auto clicked = draw_list(state, "##scene", "scene", name, make_entries(state, state.scenes, name))) {
    state.scene_asked = state.scenes[*clicked].name;
  }
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::SameLine(0.0F, gap);
  action_button(state, "<", Action::previous_scene, "previous scene");
  ImGui::SameLine(0.0F, gap);
  action_button(state, ">", Action::next_scene, "next scene");
  ImGui::SameLine(0.0F, gap);
  ImGui::TextUnformatted("scene");
}

void lay_out_garment_list(ViewerState& state) {
  const std::filesystem::path& file = state.scene.garment.file;
  const std::string name = file.empty() ? "grid" : file.stem().string();
  if (const auto clicked = draw_list(state, "garment", "garment", name, make_entries(state, state.garments, name))) {
    state.garment_asked = state.garments[*clicked].file;
  }
}

void lay_out_fabric_list(ViewerState& state) {
  const std::string name = std::filesystem::path(state.scene.fabric).stem().string();
  const std::string own_fabric = "the scene's own";
  std::vector<ListEntry> entries = make_entries(state, state.fabrics, name);
  entries.insert(entries.begin(), {own_fabric, "own", name.empty()});
  if (const auto clicked = draw_list(state, "fabric", "fabric", name.empty() ? own_fabric : name, entries)) {
    state.fabric_asked = *clicked == 0 ? "" : entries[*clicked].name;
  }
}

void lay_out_motion_list(ViewerState& state) {
  const auto& [body, file, choices] = state.motions;
  if (choices.empty()) return;
  const BodySource& source = state.scene.bodies.at(body).source;
  std::string shown = source.motion.empty() ? "none" : source.motion.stem().string();
  std::vector<ListEntry> entries;
  for (const Choice& motion : choices) {
    const bool is_first = std::ranges::none_of(entries, [](const auto& e) { return e.is_chosen; });
    entries.push_back({motion.label, motion.name, is_first && is_chosen(motion, source)});
    shown = entries.back().is_chosen ? motion.label : shown;
  }
  if (const auto clicked = draw_list(state, "motion", "motion", shown, entries)) state.motion_asked = choices[*clicked];
}

// Adapts the colours to a new bound. Colours that ended at the old bound end at the new one; other ranges grow until
// they show the bound.
void keep_range_to_bound(PictureStyle& picture, double before, double bound) {
  if (!picture.stretch_range) return;
  auto& [lowest, highest] = *picture.stretch_range;
  if (highest == before || highest < bound) highest = std::max(bound, lowest + 1e-4);
}

// Controls for the choice of the solver.
std::string chosen_substeps(const ViewerState& state) {
  const int chosen = state.newest->record.substeps;
  const bool is_most = chosen >= state.scene.simulation.solver.max_substeps;
  return chosen == 0 ? "auto" : fmt::format("auto, {}{}", chosen, is_most ? ", no more" : "");
}

// Draws two items in the space of one.
struct Halves {
  float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  float width = 0.5F * (ImGui::CalcItemWidth() - gap);

  void begin_left() const { ImGui::SetNextItemWidth(width); }
  void begin_right() const {
    ImGui::SameLine(0.0F, gap);
    ImGui::SetNextItemWidth(width);
  }
};

// Draws the slider of the bound and, for solvers with several kinds of bound, the list of kinds.
void lay_out_bound(ViewerState& state) {
  sim::BoundedSettings& bounded = state.scene.simulation.solver.bounded;
  const bool has_kinds = state.scene.simulation.solver.kind == sim::SolverKind::bounded;
  const Halves halves;
  if (has_kinds) halves.begin_left();
  double percent = 100.0 * bounded.max_stretch;
  const char* label = has_kinds ? "##max stretch" : "max stretch";
  if (number_slider(state, {label, "solver.max_stretch", percent, 0.1, 30.0, "%.2f %%", true})) {
    const double before = std::exchange(bounded.max_stretch, percent / 100.0);
    keep_range_to_bound(state.scene.picture, before, bounded.max_stretch);
  }
  if (has_kinds) {
    halves.begin_right();
    kind_list(state, "max stretch", "solver.bound", sim::all_bound_kinds, bounded.bound);
  }
}

// Draws the list of solvers and, for a solver with contact, the switch for contact.
void lay_out_solver_list(ViewerState& state) {
  SolverChoice& solver = state.scene.simulation.solver;
  const bool knows_contact = solver.kind == sim::SolverKind::bounded;
  if (knows_contact) ImGui::SetNextItemWidth(0.5F * ImGui::CalcItemWidth());
  sim::SolverKind kind = solver.kind;
  kind_list(state, "solver", "solver", sim::all_solver_kinds, kind);
  if (knows_contact) {
    ImGui::SameLine();
    ImGui::Checkbox("contact", &solver.bounded.contact);
    note_place(state, "solver.contact");
  }
  solver = with_solver(solver, kind, state.newest->loaded->scene.simulation.solver);
}

// Draws the sliders of the fabric's bending and compression stiffness.
void lay_out_stiffness(ViewerState& state) {
  sim::Material& fabric = state.scene.material;
  const double before_un_m = 1e6 * fabric.bending_rigidity_n_m;
  double bending_un_m = before_un_m;
  number_slider(state, {"bending", "fabric.bending", bending_un_m, 0.0, 200.0, "%.1f µN m", true});
  number_slider(state,
                {"compression", "fabric.compression", fabric.compression_stiffness_n_per_m, 0.0, 500.0, "%.0f N/m"});
  if (bending_un_m != before_un_m) fabric.bending_rigidity_n_m = 1e-6 * bending_un_m;
}

void lay_out_solver(ViewerState& state) {
  SolverChoice& solver = state.scene.simulation.solver;
  lay_out_solver_list(state);
  lay_out_comparison(state);
  int substeps = solver.substeps.value_or(0);
  whole_slider(state, "substeps", "solver.substeps", substeps, 0, 400,
               solver.substeps ? "%d" : chosen_substeps(state).c_str());
  solver.substeps = substeps > 0 ? std::optional(substeps) : std::nullopt;
  const bool sweeps = solver.kind == sim::SolverKind::strong;
  const bool hooke = solver.kind == sim::SolverKind::ideal || solver.kind == sim::SolverKind::provot ||
                     solver.kind == sim::SolverKind::vassilev || solver.kind == sim::SolverKind::fast_projection;
  if (sweeps) {
    whole_slider(state, "iterations", "solver.iterations", solver.strong.iterations, 1, 200);
    number_slider(state, {"flexural", "solver.flexural", solver.strong.rigidity.flexural, 0.0, 1.0, "%.3f"});
  }
  if (stretch_bound(state.scene)) lay_out_bound(state);
  if (solver.kind == sim::SolverKind::bounded) lay_out_stiffness(state);
  if (hooke) {
    sim::SpringStiffness& springs = solver.ideal.stiffness;
    number_slider(state,
                  {"bending", "solver.stiffness.flexural", springs.flexural_n_per_m, 0.0, 100.0, "%.1f N/m", true});
    number_slider(state, {"damping", "solver.stiffness.damping", springs.damping_n_s_per_m, 0.0, 0.2, "%.3f N s/m"});
  }
  if (solver.kind == sim::SolverKind::implicit) {
    number_slider(state, {"stretching", "solver.implicit.stretch", solver.implicit.stretch_n_per_m, 1.0, 10000.0,
                          "%.0f N/m", true});
    number_slider(state, {"damping", "solver.implicit.damping", solver.implicit.damping_s, 0.0, 0.05, "%.4f s"});
  }
  number_slider(state, {"air drag", "air.drag", state.scene.surroundings.forces.air_drag_per_s, 0.0, 10.0, "%.2f /s"});
}

// Wind speeds of the paper's figure 5, to which the slider snaps.
constexpr std::array<double, 2> paper_values = {1.0, 10.0};
// Distance within which the slider snaps. A larger value makes nearby speeds unreachable.
constexpr double snap_m_per_s = 0.12;

struct Colours {
  ImU32 track = ImGui::GetColorU32(ImGuiCol_FrameBg);
  ImU32 filled = ImGui::GetColorU32(ImGuiCol_SliderGrabActive);
  ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
  ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  ImU32 knob = IM_COL32(255, 255, 255, 255);
};

double snap_speed(double speed) {
  for (const double value : paper_values) {
    if (std::abs(speed - value) < snap_m_per_s) return value;
  }
  return std::round(speed * 100.0) / 100.0;
}

void draw_scale(ImDrawList& list, const Colours& colours, const ImVec2& left, float width, float scale) {
  const auto x_of = [&](double speed) { return left.x + width * static_cast<float>(speed / strongest_wind_m_per_s); };
  for (int speed = 5; speed <= 20; speed += 5) {
    if (speed == 10) continue;
    const std::string text = std::to_string(speed);
    const float x = x_of(speed);
    list.AddLine({x, left.y}, {x, left.y + 4.0F * scale}, colours.faint, scale);
    list.AddText({x - 0.5F * ImGui::CalcTextSize(text.c_str()).x, left.y + 5.0F * scale}, colours.faint, text.c_str());
  }
  for (const double speed : paper_values) {
    const std::string text = fmt::format("{:.0f}", speed);
    const float x = x_of(speed);
    list.AddTriangleFilled({x, left.y}, {x + 4.0F * scale, left.y + 6.0F * scale},
                           {x - 4.0F * scale, left.y + 6.0F * scale}, colours.ink);
    list.AddText({x - 0.5F * ImGui::CalcTextSize(text.c_str()).x, left.y + 5.0F * scale}, colours.ink, text.c_str());
  }
}

// Draws a large slider for the wind speed.
void speed_slider(ViewerState& state, float scale) {
  double& speed = state.scene.surroundings.forces.wind.speed_m_per_s;
  const float knob = 11.0F * scale;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::InvisibleButton("speed", {width, 2.0F * knob});
  note_place(state, "wind.speed");
  // The rectangle makes 0 and 1 of a session's position the ends of the slider.
  state.places["wind.speed"] = {{corner.x + knob, corner.y}, {corner.x + width - knob, corner.y + 2.0F * knob}};
  const ImVec2 left = {corner.x + knob, corner.y + knob};
  const float length = width - 2.0F * knob;
  if (ImGui::IsItemActive()) {
    const double place = std::clamp((ImGui::GetIO().MousePos.x - left.x) / length, 0.0F, 1.0F);
    speed = snap_speed(place * strongest_wind_m_per_s);
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

// Ground directions in the camera's view: up on the dial is away from the eye.
struct GroundChoice {
  glm::dvec3 away;
  glm::dvec3 right;

  explicit GroundChoice(double azimuth_rad)
      : away(-std::sin(azimuth_rad), 0.0, -std::cos(azimuth_rad)),
        right(std::cos(azimuth_rad), 0.0, -std::sin(azimuth_rad)) {}
};

void direction_dial(ViewerState& state, float radius, float scale) {
  glm::dvec3& direction = state.scene.surroundings.forces.wind.direction;
  const GroundChoice ground(state.camera.azimuth_rad());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("direction", {2.0F * radius, 2.0F * radius});
  note_place(state, "wind.direction");
  const ImVec2 centre = {corner.x + radius, corner.y + radius};
  const ImVec2 pointer = {ImGui::GetIO().MousePos.x - centre.x, ImGui::GetIO().MousePos.y - centre.y};
  if (ImGui::IsItemActive() && (pointer.x != 0.0F || pointer.y != 0.0F)) {
    // The vertical part of the wind does not change.
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
  double gust_percent = 100.0 * wind.gust_amplitude;
  if (number_slider(state, {"gusts", "wind.gust_amplitude", gust_percent, 0.0, 100.0, "%.0f %%"})) {
    wind.gust_amplitude = gust_percent / 100.0;
  }
  number_slider(state, {"gust period", "wind.gust_period", wind.gust_period_s, 0.1, 10.0, "%.1f s", true});
  double down = 0.0 - forces.gravity_m_per_s2.y;  // 0 instead of -0
  if (number_slider(state, {"gravity", "gravity", down, 0.0, 20.0, "%.2f m/s²"})) {
    forces.gravity_m_per_s2.y = -down;
  }
  ImGui::PopItemWidth();
}

}  // namespace

void lay_out_choices(ViewerState& state) {
  ImGui::Separator();
  lay_out_scene_list(state);
  lay_out_garment_list(state);
  lay_out_fabric_list(state);
  lay_out_motion_list(state);
  lay_out_solver(state);
}

void lay_out_looks(ViewerState& state) {
  PictureStyle& picture = state.scene.picture;
  ImGui::Separator();
  const auto radio = [&](const char* label, SurfaceLook look, const char* name) {
    if (ImGui::RadioButton(label, picture.surface == look)) picture.surface = look;
    note_place(state, name);
  };
  const auto check = [&](const char* label, bool& value, const char* name) {
    ImGui::Checkbox(label, &value);
    note_place(state, name);
  };
  const float third = ImGui::GetContentRegionAvail().x / 3.0F;
  const float start = ImGui::GetCursorPosX();
  radio("shaded", SurfaceLook::shaded, "look.shaded");
  ImGui::SameLine(start + third);
  radio("stretch", SurfaceLook::stretch, "look.stretch");
  ImGui::SameLine(start + 2.0F * third);
  radio("wireframe", SurfaceLook::wireframe, "look.wireframe");
  check("shadows", picture.settings.shadows, "look.shadows");
  ImGui::SameLine(start + third);
  check("normals", state.show_normals, "look.normals");
  ImGui::SameLine(start + 2.0F * third);
  ImGui::SetNextItemWidth(third);
  kind_list(state, "##springs", "look.springs", all_which_springs, picture.springs,
            picture.springs == WhichSprings::none ? "springs" : nullptr);
  check("follow", state.scene.camera.follow, "camera.follow");
  if (picture.surface == SurfaceLook::stretch) {
    ImGui::SameLine(start + third);
    kind_list(state, "stretch of", "look.stretch_of", all_stretch_of, picture.stretch_of);
  }
}

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
