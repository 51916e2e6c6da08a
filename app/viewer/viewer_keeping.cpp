#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/caches/frame_sink.hpp"
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

// Completes a recording and says what was written, or why it was not.
template <class Recording> std::string Viewer::told_end(const Recording& finish) {
  std::string outcome;
  if (const std::string error = attempt([&] { outcome = finish(); }); !error.empty()) return error;
  tell(outcome, false);
  return outcome;
}

std::optional<std::string> Viewer::finish_pictures() {
  if (!recorder_) return std::nullopt;
  state_.is_recording = false;
  const std::string outcome = told_end([this] { return recorder_->finish(); });
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
  if (!clip_) return;
  std::string end;
  const std::string error = attempt([&] {
    end = clip_->follow(state_.newest, simulation_);
    state_.clip = {clip_->file().filename(), clip_->frames()};
  });
  if (!error.empty()) {
    clip_.reset();
    state_.clip.reset();
  } else if (!end.empty()) {
    finish_clip(end);
  }
}

std::optional<std::string> Viewer::finish_clip(const std::string& reason) {
  state_.clip.reset();
  const std::unique_ptr<ClipRecorder> clip = std::move(clip_);
  return clip ? std::optional(told_end([&] { return clip->finish(simulation_) + reason; })) : std::nullopt;
}

std::vector<std::string> Viewer::finish_recordings() {
  std::vector<std::string> outcomes;
  for (auto& outcome : {finish_pictures(), finish_clip("")}) {
    if (outcome) outcomes.push_back(*outcome);
  }
  return outcomes;
}

void Viewer::take_picture(const renderer::Image& picture) {
  if (std::exchange(screenshot_, false)) {
    attempt([&] {
      const std::filesystem::path file = free_name(keep_folder_, state_.scene.name, ".png");
      write_file(file, renderer::encode_png(picture));
      tell("wrote " + file.string(), false);
    });
  }
  if (recorder_ && !attempt([&] { recorder_->add(picture, elapsed_s_); }).empty()) finish_pictures();
}

}  // namespace taut::app
