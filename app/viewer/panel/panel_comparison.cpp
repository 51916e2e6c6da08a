#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "app/scene/promise.hpp"
#include "app/viewer/panel/panel_parts.hpp"
#include "app/viewer/panel/user_interface.hpp"
#include "app/viewer/state/lost_cloth.hpp"

// The choice of a second garment, and what stands over both: to the right, where no legend is.

namespace taut::app {
namespace {

constexpr ImU32 between_colour = IM_COL32(0, 0, 0, 56);

// By what the panel plots, for both.
std::string measured_of(const Snapshot& garment, const ViewerState& state) {
  const bool of_springs = bound_kind(state.scene) == sim::BoundKind::springs;
  const FrameRecord& record = garment.record;
  const double largest = of_springs ? record.stretch.max : record.surface_stretch.max;
  const std::string stretch = fmt::format("largest stretch {} %", in_little_room(100.0 * largest, 2));
  return state.measurements.shows_times
             ? fmt::format("{}, {} ms a frame", stretch, few_digits(static_cast<float>(record.sim_ms)))
             : stretch;
}

std::string lost_of(const Snapshot& garment, const ViewerState& state, const ViewArea& area) {
  return garment.stopped
             ? fmt::format("stopped at {:.2f} s: R starts both again", garment.record.time_s)
             : lost_cloth(garment.positions(), garment.loaded->garment->mesh.triangles, state.camera, area);
}

void lay_out_label(const char* name, const Snapshot& garment, const ViewerState& state, const ViewArea& area,
                   const ImVec2& corner) {
  ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {1.0F, 0.0F});
  ImGui::SetNextWindowBgAlpha(0.85F);
  if (ImGui::Begin(name, nullptr, untouchable)) {
    ImGui::PushTextWrapPos(std::max(0.8F * static_cast<float>(area.width_px), 16.0F));
    ImGui::TextUnformatted(solver_of(garment));
    ImGui::TextUnformatted(measured_of(garment, state).c_str());
    if (const std::string lost = lost_of(garment, state, area); !lost.empty()) {
      ImGui::TextColored({0.70F, 0.12F, 0.10F, 1.0F}, "%s", lost.c_str());
    }
    ImGui::PopTextWrapPos();
  }
  ImGui::End();
}

}  // namespace

void lay_out_comparison(ViewerState& state) {
  std::optional<sim::SolverKind>& with = state.compared_with;
  if (begin_list("compare with", with ? sim::name_of(*with) : "none")) {
    if (ImGui::Selectable("none", !with)) {
      with.reset();
    }
    note_place(state, "compare.none");
    for (const sim::SolverKind kind : sim::all_solver_kinds) {
      if (ImGui::Selectable(sim::name_of(kind), with == kind)) {
        with = kind;
      }
      note_place(state, (std::string("compare.") + sim::name_of(kind)).c_str());
    }
    ImGui::EndCombo();
  }
  note_place(state, "compare");
}

void lay_out_labels(const ViewerState& state, const ViewArea& area, float scale) {
  const Snapshot* second = compared(state);
  if (second == nullptr) {
    return;
  }
  const auto width = static_cast<float>(area.width_px);
  const auto height = static_cast<float>(area.height_px);
  const float gap = 10.0F * scale;
  lay_out_label("legends, left", *state.shown, state, area, {width - gap, gap});
  lay_out_label("legends, right", *second, state, area, {2.0F * width - gap, gap});
  if (ImGui::Begin("legends, right")) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    list.AddLine({width, -1.0F}, {width, height}, between_colour, scale);
    list.PopClipRect();
  }
  ImGui::End();
}

}  // namespace taut::app
