#include <fmt/core.h>

#include <utility>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/caches/written_cloth.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/viewer/viewer.hpp"
#include "renderer/page/png.hpp"

// Files that the viewer writes.

namespace taut::app {

void Viewer::save_scene() {
  const std::filesystem::path file = free_name(keep_folder_, state_.scene.name, ".toml");
  DrawnScene scene = kept_scene(state_, area_of_one());
  if (!is_pristine(state_)) {
    const std::filesystem::path moment = std::filesystem::path(file).replace_extension(".checkpoint");
    scene.checkpoint = moment.filename();
    write_run_checkpoint(moment, kept_moment(state_, scene));
  }
  write_text_file(file, scene_text(scene, GarmentNaming::full_path));
  tell(fmt::format("saved {}; taut render of it draws this frame", file.string()), false);
}

void Viewer::export_shape() {
  const std::filesystem::path file = free_name(keep_folder_, state_.scene.name, ".obj");
  write_text_file(file, WrittenCloth(*state_.shown->loaded).obj(state_.shown->positions()));
  tell("wrote " + file.string() + ", in metres with y up", false);
}

void Viewer::start_or_stop_recording() {
  if (recorder_) {
    finish_pictures();
    return;
  }
  const ViewArea area = scene_area(layout());
  recorder_.emplace(keep_folder_, state_.scene.name, state_.recording_kind, area.width_px, area.height_px);
  state_.is_recording = true;
  tell("recording; F10 ends it", false);
}

std::optional<std::string> Viewer::finish_pictures() {
  if (!recorder_) {
    return std::nullopt;
  }
  state_.is_recording = false;
  std::string outcome;
  try {
    outcome = recorder_->finish();
    tell(outcome, false);
  } catch (const InputError& error) {
    outcome = error.what();
    tell(outcome, true);
  }
  recorder_.reset();
  return outcome;
}

void Viewer::start_or_stop_clip() {
  if (clip_) {
    finish_clip("");
  } else if (state_.shown != state_.newest) {
    tell("this is past: Space goes on from here, then X begins a clip", false);
  } else {
    clip_ = std::make_unique<ClipRecorder>(keep_folder_, state_.clip_format, state_.newest);
    tell("a clip begins in " + clip_->file().string() + "; X ends it", false);
    follow_clip();
  }
}

void Viewer::follow_clip() {
  if (!clip_) {
    return;
  }
  try {
    const std::string end = clip_->follow(state_.newest, simulation_);
    state_.clip = {clip_->file().filename(), clip_->frames()};
    if (!end.empty()) {
      finish_clip(end);
    }
  } catch (const std::exception& error) {
    tell(error.what(), true);
    clip_.reset();
    state_.clip.reset();
  }
}

std::optional<std::string> Viewer::finish_clip(const std::string& reason) {
  state_.clip.reset();
  const std::unique_ptr<ClipRecorder> clip = std::move(clip_);
  if (!clip) {
    return std::nullopt;
  }
  std::string outcome;
  try {
    outcome = clip->finish(simulation_) + reason;
    tell(outcome, false);
  } catch (const std::exception& error) {
    outcome = error.what();
    tell(outcome, true);
  }
  return outcome;
}

std::vector<std::string> Viewer::finish_recordings() {
  std::vector<std::string> outcomes;
  for (auto& outcome : {finish_pictures(), finish_clip("")}) {
    if (outcome) {
      outcomes.push_back(*outcome);
    }
  }
  return outcomes;
}

void Viewer::take_picture(const renderer::Image& picture) {
  try {
    if (std::exchange(screenshot_, false)) {
      const std::filesystem::path file = free_name(keep_folder_, state_.scene.name, ".png");
      write_file(file, renderer::encode_png(picture));
      tell("wrote " + file.string(), false);
    }
  } catch (const std::runtime_error& error) {
    tell(error.what(), true);
  }
  if (!recorder_) {
    return;
  }
  try {
    recorder_->add(picture, elapsed_s_);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    tell(error.what(), true);
    finish_pictures();
  }
}

}  // namespace taut::app
