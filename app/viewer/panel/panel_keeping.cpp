#include <imgui.h>

#include "app/viewer/panel/panel_parts.hpp"

namespace taut::app {
namespace {

// The list of formats makes way for how far it is.
void lay_out_clip(ViewerState& state, float button_px) {
  action_button(state, state.clip ? "Stop X" : "Clip X", Action::record_clip, "keep.clip", button_px);
  ImGui::SameLine();
  if (state.clip) {
    ImGui::Text("%d to %s", state.clip->frames, state.clip->file.c_str());
    note_place(state, "keep.clip_frames");
    return;
  }
  ImGui::SetNextItemWidth(button_px);
  kind_list(state, "of shapes", "keep.clip_format", all_clip_formats, state.clip_format);
}

}  // namespace

void lay_out_keeping(ViewerState& state) {
  ImGui::Separator();
  const float width = (ImGui::GetContentRegionAvail().x - 2.0F * ImGui::GetStyle().ItemSpacing.x) / 3.0F;
  action_button(state, "Picture F12", Action::screenshot, "keep.screenshot", width);
  ImGui::SameLine();
  action_button(state, "Scene S", Action::save_scene, "keep.scene", width);
  ImGui::SameLine();
  action_button(state, "Camera C", Action::copy_camera, "keep.camera", width);
  action_button(state, state.is_recording ? "Stop F10" : "Record F10", Action::record, "keep.record", width);
  ImGui::SameLine();
  if (ImGui::RadioButton("video", state.recording_kind == RecordingKind::video)) {
    state.recording_kind = RecordingKind::video;
  }
  note_place(state, "keep.video");
  ImGui::SameLine();
  if (ImGui::RadioButton("PNG", state.recording_kind == RecordingKind::pictures)) {
    state.recording_kind = RecordingKind::pictures;
  }
  note_place(state, "keep.pictures");
  ImGui::SameLine();
  action_button(state, "Shape E", Action::export_shape, "keep.shape", ImGui::GetContentRegionAvail().x);
  lay_out_clip(state, width);
}

}  // namespace taut::app
