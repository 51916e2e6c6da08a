#include "app/viewer/panel/panel.hpp"

#include <fmt/core.h>

#include "app/scene/scene_format.hpp"
#include "app/viewer/panel/panel_parts.hpp"
#include "app/viewer/panel/user_interface.hpp"

// The panel and its hints, the list of solvers for a second garment, and the labels over both garments. List and labels
// are at the right, where there is no legend.

namespace taut::app {
namespace {

// width at scale 1
constexpr float panel_width_px = 320.0F;
// Time that the pointer must rest on an item before its hint appears. A shorter time makes the panel flicker.
constexpr double hint_after_s = 0.5;
// size of each picture in the sheet of thumbnails
constexpr glm::ivec2 thumbnail_px{96, 72};

int panel_width(const WindowLayout& layout) { return static_cast<int>(panel_width_px * layout.scale); }

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
  if (text.empty() || is_hint_due(state)) return;
  constexpr float letters_in_line = 26.0F;
  // The hint is left of the panel and its lists, or above the time bar, where it does not cover the item or its text.
  const ImVec2 lower = ImGui::GetItemRectMin(), size = ImGui::GetIO().DisplaySize;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const bool is_beside = lower.x > 0.5F * size.x && ImGui::GetWindowPos().x > 0.0F;
  const ImVec2 corner = is_beside ? ImVec2(ImGui::GetWindowPos().x - gap, lower.y) : ImVec2(lower.x, lower.y - gap);
  ImGui::SetNextWindowPos(corner, ImGuiCond_Always,
                          {is_beside ? 1.0F : lower.x / size.x, is_beside ? lower.y / size.y : 1.0F});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(letters_in_line * ImGui::GetFontSize());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

constexpr ImU32 between_colour = IM_COL32(0, 0, 0, 56);

std::string describe_measurement(const Snapshot& garment, const ViewerState& state) {
  const FrameRecord& record = garment.record;
  const std::string stretch =
      fmt::format("largest stretch {} % of springs, {} % of the surface", short_number(100.0 * record.stretch.max, 2),
                  short_number(100.0 * record.surface_stretch.max, 2));
  return state.measurements.shows_times
             ? fmt::format("{}, {} ms a frame", stretch, few_digits(static_cast<float>(record.sim_ms)))
             : stretch;
}

std::string describe_loss(const Snapshot& garment, const ViewerState& state, const ViewArea& area) {
  return garment.stopped ? fmt::format("stopped at {:.2f} s: R starts both again", garment.record.time_s)
                         : lost_cloth(garment.positions(), garment.loaded->garment->mesh.triangles, state.camera, area);
}

void lay_out_label(const char* name, const Snapshot& garment, const ViewerState& state, const ViewArea& area,
                   const ImVec2& corner) {
  ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {1.0F, 0.0F});
  ImGui::SetNextWindowBgAlpha(0.85F);
  if (ImGui::Begin(name, nullptr, untouchable)) {
    ImGui::PushTextWrapPos(std::max(0.8F * static_cast<float>(area.width_px), 16.0F));
    ImGui::TextUnformatted(solver_name(garment));
    ImGui::TextUnformatted(describe_measurement(garment, state).c_str());
    if (const std::string lost = describe_loss(garment, state, area); !lost.empty()) {
      ImGui::TextColored({0.70F, 0.12F, 0.10F, 1.0F}, "%s", lost.c_str());
    }
    ImGui::PopTextWrapPos();
  }
  ImGui::End();
}

bool panel_fits(const WindowLayout& layout) {
  return layout.has_panel && layout.width_px > 2 * panel_width(layout) - panel_width(layout) / 2;
}

}  // namespace

ViewArea scene_area(const WindowLayout& layout) {
  const int panel_px = panel_fits(layout) ? panel_width(layout) : 0;
  return {std::max(layout.width_px - panel_px, 1), std::max(layout.height_px, 1)};
}

ViewArea garment_area(const ViewerState& state, const WindowLayout& layout) {
  const ViewArea whole = scene_area(layout);
  return compared_garment(state) != nullptr ? ViewArea{std::max(whole.width_px / 2, 1), whole.height_px} : whole;
}

void lay_out(ViewerState& state, const WindowLayout& layout) {
  state.places.clear();
  const std::optional<Hovered> before = state.hovered;
  const ViewArea area = scene_area(layout);
  lay_out_legends(state, layout.scale);
  lay_out_labels(state, garment_area(state, layout), layout.scale);
  if (panel_fits(layout)) lay_out_panel(state, layout, area);
  if (layout.has_panel) lay_out_time_bar(state, area, layout.scale);
  lay_out_messages(state, area, layout.scale);
  lay_out_key_sheet(state, area);
  // No item was under the pointer in this frame: the time over the last item did not grow.
  if (before && state.hovered && before->name == state.hovered->name && before->for_s == state.hovered->for_s) {
    state.hovered.reset();
  }
}

void note_place(ViewerState& state, const char* name) {
  const ImVec2 lower = ImGui::GetItemRectMin();
  const ImVec2 upper = ImGui::GetItemRectMax();
  state.places[name] = {{lower.x, lower.y}, {upper.x, upper.y}};
  if (ImGui::IsItemHovered() && !ImGui::IsAnyMouseDown()) explain(state, name);
}

// Draws an entry and returns true if it was clicked. A thumbnail is left of the text.
bool lay_out_entry(const ListEntry& entry) {
  if (!entry.thumbnail) return ImGui::Selectable(entry.label.c_str(), entry.is_chosen);
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const ImFontAtlasCustomRect& sheet = *atlas.GetCustomRectByIndex(0);
  const auto number = static_cast<int>(*entry.thumbnail);
  const int columns = sheet.Width / thumbnail_px.x;
  const auto uv = [&](int column, int row) {
    return ImVec2{atlas.TexUvScale.x * static_cast<float>(sheet.X + (number % columns + column) * thumbnail_px.x),
                  atlas.TexUvScale.y * static_cast<float>(sheet.Y + (number / columns + row) * thumbnail_px.y)};
  };
  const float height = 2.4F * ImGui::GetFontSize();
  const float width = height * static_cast<float>(thumbnail_px.x) / static_cast<float>(thumbnail_px.y);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float text = width + ImGui::GetStyle().ItemSpacing.x;
  const float needed = text + ImGui::CalcTextSize(entry.label.c_str()).x;
  const bool is_clicked = ImGui::Selectable(("##" + entry.name).c_str(), entry.is_chosen, ImGuiSelectableFlags_None,
                                            {std::max(needed, ImGui::GetContentRegionAvail().x), height});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddImage(atlas.TexID, corner, {corner.x + width, corner.y + height}, uv(0, 0), uv(1, 1));
  list.AddText({corner.x + text, corner.y + 0.5F * (height - ImGui::GetFontSize())}, ImGui::GetColorU32(ImGuiCol_Text),
               entry.label.c_str());
  return is_clicked;
}

std::optional<std::size_t> draw_list(ViewerState& state, const char* label, const std::string& name,
                                     const std::string& closed, const std::vector<ListEntry>& entries) {
  std::optional<std::size_t> clicked;
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {FLT_MAX, 0.9F * ImGui::GetIO().DisplaySize.y});
  if (ImGui::BeginCombo(label, closed.c_str(), ImGuiComboFlags_HeightLarge)) {
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) ImGui::CloseCurrentPopup();
    for (std::size_t k = 0; k < entries.size(); ++k) {
      clicked = lay_out_entry(entries[k]) ? k : clicked;
      if (entries[k].is_chosen && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
      note_place(state, (name + '.' + entries[k].name).c_str());
    }
    ImGui::EndCombo();
  }
  note_place(state, name.c_str());
  return clicked;
}

bool is_hint_due(const ViewerState& state) { return state.hovered && state.hovered->for_s < hint_after_s; }

void action_button(ViewerState& state, const char* label, Action action, const char* name, float width_px) {
  if (ImGui::Button(label, {width_px, 0.0F})) state.asked.push_back(action);
  note_place(state, name);
}

bool number_slider(ViewerState& state, const Slider& s) {
  const bool changed = ImGui::SliderScalar(
      s.label, ImGuiDataType_Double, &s.value, &s.lowest, &s.highest, s.format,
      ImGuiSliderFlags_AlwaysClamp | (s.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None));
  note_place(state, s.name);
  return changed;
}

bool whole_slider(ViewerState& state, const char* label, const char* name, int& value, int lowest, int highest,
                  const char* format) {
  const bool changed = ImGui::SliderInt(label, &value, lowest, highest, format,
                                        ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
  note_place(state, name);
  return changed;
}

void lay_out_comparison(ViewerState& state) {
  std::optional<sim::SolverKind>& with = state.compared_with;
  std::vector<ListEntry> entries = {{"none", "none", !with}};
  for (const sim::SolverKind kind : sim::all_solver_kinds) {
    entries.push_back({sim::to_name(kind), sim::to_name(kind), with == kind});
  }
  if (const auto clicked = draw_list(state, "compare with", "compare", with ? sim::to_name(*with) : "none", entries)) {
    with = *clicked == 0 ? std::nullopt : std::optional(sim::all_solver_kinds[*clicked - 1]);
  }
}

void lay_out_labels(const ViewerState& state, const ViewArea& area, float scale) {
  const Snapshot* second = compared_garment(state);
  if (second == nullptr) return;
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

void lay_out_keeping(ViewerState& state) {
  ImGui::Separator();
  const float width = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  action_button(state, "Picture F12", Action::screenshot, "keep.screenshot", width);
  ImGui::SameLine();
  action_button(state, "Scene S", Action::save_scene, "keep.scene", width);
  action_button(state, state.is_recording ? "Stop F10" : "Video F10", Action::record, "keep.video", width);
  ImGui::SameLine();
  action_button(state, "Shape E", Action::export_shape, "keep.shape", width);
}

std::string hint_for(const std::string& name) {
  static const toml::table hints = toml::parse(hint_texts);
  if (const auto* text = hints.get_as<std::string>(name)) return text->get();
  constexpr std::string_view compare = "compare.";
  if (name.starts_with(compare)) return hint_for("solver." + name.substr(compare.size()));
  static const std::vector<Key<Scene>> keys = scene_keys();
  const auto key = std::ranges::find(keys, name, &Key<Scene>::name);
  if (key == keys.end()) return "";
  const std::string meaning = key_meaning(name), unit = key->unit.empty() ? "" : ", in " + key->unit;
  return static_cast<char>(std::toupper(meaning[0])) + meaning.substr(1) + unit + '.';
}

}  // namespace taut::app
