#include <fmt/core.h>
#include <imgui.h>

#include "app/scene/scene.hpp"
#include "app/viewer/panel/panel_parts.hpp"
#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {
namespace {

void lay_out_presets(ViewerState& state) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Figures");
  for (const Choice& scene : state.scenes) {
    if (scene.label.empty()) continue;
    const float width = ImGui::CalcTextSize(scene.label.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
    const float end = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width;
    if (end < ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x) ImGui::SameLine();
    if (ImGui::Button(scene.label.c_str())) state.scene_asked = scene.name;
    note_place(state, ("preset." + scene.name).c_str());
  }
}

std::vector<ListEntry> entries_of(const std::vector<Choice>& choices, const std::string& chosen) {
  std::vector<ListEntry> entries;
  for (const Choice& choice : choices) entries.push_back({choice.name, choice.name, choice.name == chosen});
  return entries;
}

void lay_out_scene_list(ViewerState& state) {
  const std::string& name = state.scene.name;
  if (const auto clicked = list_of(state, "scene", "scene", name, entries_of(state.scenes, name))) {
    state.scene_asked = state.scenes[*clicked].name;
  }
}

void lay_out_garment_list(ViewerState& state) {
  const std::filesystem::path& file = state.scene.garment.file;
  const std::string name = file.empty() ? "grid" : file.stem().string();
  if (const auto clicked = list_of(state, "garment", "garment", name, entries_of(state.garments, name))) {
    state.garment_asked = state.garments[*clicked].file;
  }
}

void lay_out_fabric_list(ViewerState& state) {
  const std::string name = std::filesystem::path(state.scene.fabric).stem().string();
  const std::string own = "the scene's own";
  std::vector<ListEntry> entries = entries_of(state.fabrics, name);
  entries.insert(entries.begin(), {own, "own", name.empty()});
  if (const auto clicked = list_of(state, "fabric", "fabric", name.empty() ? own : name, entries)) {
    state.fabric_asked = *clicked == 0 ? "" : entries[*clicked].name;
  }
}

void lay_out_motion_list(ViewerState& state) {
  const auto& [body, file, choices] = state.motions;
  if (choices.empty()) return;
  const BodySource& source = state.scene.body_sources.at(body);
  std::string shown = source.motion.empty() ? "none" : source.motion.stem().string();
  std::vector<ListEntry> entries;
  for (const Choice& motion : choices) {
    const bool is_first = std::ranges::none_of(entries, [](const auto& e) { return e.is_chosen; });
    entries.push_back({motion.label, motion.name, is_first && is_chosen(motion, source)});
    shown = entries.back().is_chosen ? motion.label : shown;
  }
  if (const auto clicked = list_of(state, "motion", "motion", shown, entries)) {
    state.motion_asked = choices[*clicked];
  }
}

// Colours that ended at the bound go on ending there; others have to show where it is.
void keep_range_to_bound(PictureStyle& picture, double before, double bound) {
  if (!picture.stretch_range) return;
  auto& [lowest, highest] = *picture.stretch_range;
  if (highest == before || highest < bound) highest = std::max(bound, lowest + 1e-4);
}

// Choices of the solver.
std::string chosen_substeps(const ViewerState& state) {
  const int chosen = state.newest->record.substeps;
  const bool is_most = chosen >= state.scene.simulation.solver.max_substeps;
  return chosen == 0 ? "auto" : fmt::format("auto, {}{}", chosen, is_most ? ", no more" : "");
}

// Two items in the place of one.
struct Halves {
  float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  float width = 0.5F * (ImGui::CalcItemWidth() - gap);

  void begin_left() const { ImGui::SetNextItemWidth(width); }
  void begin_right() const {
    ImGui::SameLine(0.0F, gap);
    ImGui::SetNextItemWidth(width);
  }
};

// How much, and beside it of what where there is a choice.
void lay_out_bound(ViewerState& state) {
  sim::BoundedSettings& bounded = state.scene.simulation.solver.bounded;
  const bool has_kinds = state.scene.simulation.solver.kind == sim::SolverKind::bounded;
  const Halves halves;
  if (has_kinds) halves.begin_left();
  double percent = 100.0 * bounded.max_stretch;
  const char* label = has_kinds ? "##max stretch" : "max stretch";
  if (number_slider(state, label, "solver.max_stretch", percent, 0.1, 30.0, "%.2f %%", true)) {
    const double before = std::exchange(bounded.max_stretch, percent / 100.0);
    keep_range_to_bound(state.scene.picture, before, bounded.max_stretch);
  }
  if (has_kinds) {
    halves.begin_right();
    kind_list(state, "max stretch", "solver.bound", sim::all_bound_kinds, bounded.bound);
  }
}

// The list of solvers, and beside it whether there is contact where the solver knows any.
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

// Two sliders side by side; the second one's label stands for both.
struct Slider {
  const char* label;
  const char* name;
  double& value;
  double lowest;
  double highest;
  const char* format;
  bool logarithmic = false;
};

void slider_pair(ViewerState& state, const Slider& left, const Slider& right) {
  const Halves halves;
  const auto lay_out = [&](const Slider& s) {
    number_slider(state, s.label, s.name, s.value, s.lowest, s.highest, s.format, s.logarithmic);
  };
  halves.begin_left();
  lay_out(left);
  halves.begin_right();
  lay_out(right);
}

// Sliders of the fabric: its stiffness against bending, and against crumpling.
void lay_out_stiffness(ViewerState& state) {
  sim::Material& fabric = state.scene.material;
  const double before_un_m = 1e6 * fabric.bending_rigidity_n_m;
  double bending_un_m = before_un_m;
  slider_pair(
      state, {"##flexural", "fabric.bending", bending_un_m, 0.0, 200.0, "%.1f µN m", true},
      {"stiffness", "fabric.compression", fabric.compression_stiffness_n_per_m, 0.0, 500.0, "%.0f N/m"});
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
                     solver.kind == sim::SolverKind::vassilev ||
                     solver.kind == sim::SolverKind::fast_projection;
  if (sweeps) {
    whole_slider(state, "iterations", "solver.iterations", solver.strong.iterations, 1, 200);
    number_slider(state, "flexural", "solver.flexural", solver.strong.rigidity.flexural, 0.0, 1.0, "%.3f");
  }
  if (stretch_bound(state.scene)) lay_out_bound(state);
  if (solver.kind == sim::SolverKind::bounded) lay_out_stiffness(state);
  if (hooke) {
    sim::SpringStiffness& springs = solver.ideal.stiffness;
    slider_pair(
        state,
        {"##flexural", "solver.stiffness.flexural", springs.flexural_n_per_m, 0.0, 100.0, "%.1f N/m", true},
        {"bend, damp", "solver.stiffness.damping", springs.damping_n_s_per_m, 0.0, 0.2, "%.3f N s/m"});
  }
  if (solver.kind == sim::SolverKind::implicit) {
    slider_pair(state,
                {"##stretch stiffness", "solver.implicit.stretch", solver.implicit.stretch_n_per_m, 1.0,
                 10000.0, "%.0f N/m", true},
                {"stretch, damp", "solver.implicit.damping", solver.implicit.damping_s, 0.0, 0.05, "%.4f s"});
  }
  number_slider(state, "air drag", "air.drag", state.scene.surroundings.forces.air_drag_per_s, 0.0, 10.0,
                "%.2f /s");
}

}  // namespace

void lay_out_choices(ViewerState& state) {
  ImGui::Separator();
  lay_out_presets(state);
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
  kind_list(state, "##springs", "look.springs", all_which_springs, picture.springs.which,
            picture.springs.which == WhichSprings::none ? "springs" : nullptr);
  if (picture.surface == SurfaceLook::stretch) {
    kind_list(state, "stretch of", "look.stretch_of", all_stretch_of, picture.stretch_of);
  }
}

}  // namespace taut::app
