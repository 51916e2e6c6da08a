#include "app/viewer/viewer.hpp"

#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "app/drawing/framing.hpp"
#include "app/models/reading/import_process.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

// H.264 needs even width and height.
int round_to_even(int side_px) { return std::max(side_px / 2 * 2, 2); }

renderer::Image crop(const renderer::Image& image, int width_px, int height_px) {
  if (image.width_px == width_px && image.height_px == height_px) return image;
  renderer::Image part = renderer::make_image(width_px, height_px);
  for (int y = 0; y < height_px; ++y) {
    std::copy_n(image.at(0, y), static_cast<std::size_t>(width_px) * 3U, part.at(0, y));
  }
  return part;
}

std::vector<PinSelector> numbered_in_file(const std::vector<sim::Index>& pins, const FileVertices& vertices) {
  std::vector<PinSelector> numbers;
  for (const sim::Index pin : pins) {
    const std::optional<sim::Index> number = vertices.number_of(pin);
    if (!number) {
      throw InputError(
          "cannot save a pin between the vertices of the garment's file, where garment.subdivisions put one; "
          "take it off, or pin a vertex of the file");
    }
    numbers.emplace_back(*number);
  }
  return numbers;
}

sim::Surroundings make_surroundings(const ViewerState& state) {
  return settle_surroundings(state.scene.surroundings, *state.shown->loaded, state.shown->loaded->bodies.all);
}

}  // namespace

DrawnScene kept_scene(const ViewerState& state, const ViewArea& area) {
  constexpr int min_side_px = 16;
  DrawnScene scene = state.scene;
  const Snapshot& shown = *state.shown;
  const std::vector<sim::Index>& pins = *shown.pins;
  if (pins != shown.loaded->pins) scene.pins = numbered_in_file(pins, shown.loaded->file_vertices);
  const renderer::Camera camera = camera_at_rest(state, shown);
  scene.camera.eye = camera.eye;
  scene.camera.target = camera.target;
  scene.camera.framing.vertical_fov_rad = camera.vertical_fov_rad;
  scene.frames = std::max(1, shown.record.frame);
  if (!scene.checkpoint.empty()) scene.checkpoint = fs::absolute(scene.checkpoint);
  scene.picture.settings.width_px = std::max(area.width_px, min_side_px);
  scene.picture.settings.height_px = std::max(area.height_px, min_side_px);
  return scene;
}

bool is_pristine(const ViewerState& state) {
  const Snapshot& shown = *state.shown;
  return shown.pristine && shown.settings == simulation_settings(state.scene.simulation) &&
         shown.garment->material == state.scene.material && shown.surroundings == make_surroundings(state);
}

RunCheckpoint kept_moment(const ViewerState& state, const DrawnScene& kept) {
  const sim::Simulation simulation = continue_from(*state.shown, simulation_settings(state.scene.simulation),
                                                   state.scene.material, make_surroundings(state));
  return {
      kept.name, scene_text(kept), state.shown->record.frame, {}, sim::encode(simulation.save(), simulation.garment())};
}

WindowRecorder::WindowRecorder(const fs::path& folder, const std::string& stem, int width_px, int height_px)
    : file_(free_name(folder, stem, ".mp4")), width_px_(round_to_even(width_px)), height_px_(round_to_even(height_px)) {
  prepare_parent_folder(file_);
  video_ = std::make_unique<VideoWriter>(file_, VideoSettings{width_px_, height_px_, rate_hz, true});
}

void WindowRecorder::add(const renderer::Image& picture, double elapsed_s) {
  if (picture.width_px < width_px_ || picture.height_px < height_px_) {
    throw std::invalid_argument("the picture has become smaller than the recording");
  }
  const renderer::Image part = crop(picture, width_px_, height_px_);
  owed_s_ += frames_ == 0 ? 1.0 / rate_hz : std::min(elapsed_s, 1.0);
  for (; owed_s_ >= 1.0 / rate_hz; owed_s_ -= 1.0 / rate_hz, ++frames_) video_->add(part);
}

std::string WindowRecorder::finish() {
  video_->finish();
  return fmt::format("wrote {}, {}", file_.string(), count_text(frames_, "frame"));
}

using renderer::PointerButton;

std::optional<PickedPoint> cloth_under(const glm::vec2& place_px, const ViewArea& area, const ViewerState& state,
                                       const Snapshot& garment) {
  if (!area.contains(place_px)) return std::nullopt;
  return pick(state.camera.ray_through(place_px, area), garment.positions(),
              state.shown->loaded->garment->mesh.triangles);
}

std::optional<HeldCloth> Hands::held() const {
  return hold_ ? std::optional(HeldCloth{hold_->grip.vertices.front().vertex, hold_->grip.target_m}) : std::nullopt;
}

void Hands::press(const Pointer& pointer, const ViewArea& area, const ViewerState& state,
                  std::vector<SimulationCommand>& commands) {
  const bool was_drawn = seen_ && seen_->loaded == pointed_at(state).loaded;
  const Snapshot& seen = was_drawn ? *seen_ : pointed_at(state);
  const auto picked = cloth_under(pointer.position_px, area, state, seen);
  const bool is_past = state.shown != state.newest;
  if (!picked || is_past) {
    is_turning_ = true;
    return;
  }
  const std::vector<sim::Vec3>& positions = seen.positions();
  Hold hold;
  hold.grip = take_grip(*state.shown->loaded->garment, positions, picked->vertex);
  hold.through = picked->point_m;
  hold.to_vertex = positions[picked->vertex] - picked->point_m;
  commands.emplace_back(TakeHold{hold.grip});
  hold_ = std::move(hold);
}

void Hands::pull(const Pointer& pointer, const ViewArea& area, const ViewerState& state,
                 std::vector<SimulationCommand>& commands) {
  const auto point =
      drag_point(state.camera.ray_through(pointer.position_px, area), hold_->through, state.camera.camera());
  if (point && *point + hold_->to_vertex != hold_->grip.target_m) {
    hold_->grip.target_m = *point + hold_->to_vertex;
    commands.emplace_back(TakeHold{hold_->grip});
  }
}

void Hands::update(const Pointer& pointer, bool is_free, const ViewArea& area, ViewerState& state,
                   std::vector<SimulationCommand>& commands) {
  if (is_free && area.contains(pointer.position_px)) {
    if (pointer.was_pressed(PointerButton::left)) press(pointer, area, state, commands);
    is_moving_ = is_moving_ || pointer.was_pressed(PointerButton::right) || pointer.was_pressed(PointerButton::middle);
    if (pointer.notches != 0.0F) state.camera.zoom(pointer.notches, pointer.position_px, area);
  }
  if (!pointer.is_down(PointerButton::left)) {
    if (hold_) commands.emplace_back(LetGo{});
    hold_.reset();
    is_turning_ = false;
  }
  is_moving_ = is_moving_ && (pointer.is_down(PointerButton::right) || pointer.is_down(PointerButton::middle));
  if (is_turning_) state.camera.orbit(pointer.movement_px, area);
  if (is_moving_) state.camera.pan(pointer.movement_px, area);
  if (hold_) pull(pointer, area, state, commands);
}

namespace {

namespace keys = renderer::keys;

// Fraction of the picture that stays free around the garment at its start, because wind and hands move it.
constexpr float window_margin = 0.16F;

bool is_down(const std::set<int>& down, int one, int other) { return down.contains(one) || down.contains(other); }

}  // namespace

Viewer::Viewer(SimulationHost& simulation, const ViewerSettings& settings)
    : simulation_(simulation),
      keep_folder_(settings.keep_folder),
      size_(settings.size),
      scale_(settings.scale),
      interface_(settings.scale) {
  state_.measurements.shows_times = settings.shows_times;
  state_.compared_with = settings.compared_with;
  state_.scenes = scene_choices();
  state_.garments = garment_choices();
  state_.fabrics = files_in("fabrics", ".toml");
  thumbnails_ = std::async(std::launch::async, read_image, assets_folder() / "scenes" / "thumbnails.png");
  note_snapshot(simulation_.begin_frame(0.0, std::nullopt));
}

// Takes the thumbnails over once they are loaded. Waits for them only if the picture must depend on the input alone.
void Viewer::take_thumbnails() {
  const bool waits = !state_.measurements.shows_times;
  if (!thumbnails_.valid()) return;
  if (!waits && thumbnails_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  attempt([&] {
    interface_.set_thumbnails(thumbnails_.get());
    std::istringstream names(read_text_file(assets_folder() / "scenes" / "thumbnails.txt"));
    state_.thumbnails.assign(std::istream_iterator<std::string>(names), {});
  });
}

WindowLayout Viewer::layout() const {
  return {std::max(size_.width_px, 1), std::max(size_.height_px, 1), static_cast<float>(scale_), state_.show_panel};
}

SessionFrame Viewer::update(SessionFrame frame) {
  elapsed_s_ = frame.elapsed_s;
  pointer_.pressed = {};
  pointer_.notches = 0.0F;
  pointer_.movement_px = {0.0F, 0.0F};
  for (const SessionEvent& event : frame.events) take(event);

  const std::uint64_t advances_before = state_.newest->advances;
  note_snapshot(simulation_.begin_frame(frame.elapsed_s, frame.pace));
  note_speed(advances_before);
  warn();
  take_thumbnails();
  interface_.begin_frame(layout().width_px, layout().height_px, frame.elapsed_s);
  lay_out(state_, layout());
  hands_.update(pointer_over_one(), !interface_.wants_pointer(), area_of_one(), state_, commands_);
  state_.held = hands_.held();
  hands_.note_seen(state_.is_over_second && state_.shown->compared ? state_.shown->compared : state_.shown);
  for (const Action action : std::exchange(state_.asked, {})) attempt([&] { perform(action); });
  load_asked();
  collect_settings();
  const std::uint64_t advances = simulation_.post(std::exchange(commands_, {}));
  interface_.end_frame();
  frame.pace = Pace{advances, state_.newest->serial};
  note_changes(frame);
  return frame;
}

void Viewer::take(const SessionEvent& event) {
  if (const auto* at = std::get_if<PointAt>(&event)) {
    const auto place = state_.places.find(at->item);
    if (place == state_.places.end()) {
      throw InputError("the session points at '" + at->item + "', which the panel does not show");
    }
    const glm::vec2 part(static_cast<float>(at->x), static_cast<float>(at->y));
    const glm::vec2 point = glm::mix(place->second.lower_px, place->second.upper_px, part);
    take(renderer::WindowEvent(renderer::PointerMoved{point.x, point.y}));
  } else if (const auto* from_window = std::get_if<renderer::WindowEvent>(&event)) {
    take(*from_window);
  }
}

void Viewer::take(const renderer::WindowEvent& event) {
  interface_.feed(event);
  if (const auto* moved = std::get_if<renderer::PointerMoved>(&event)) {
    const glm::vec2 place{moved->x_px, moved->y_px};
    pointer_.movement_px += place - pointer_.position_px;
    pointer_.position_px = place;
  } else if (const auto* button = std::get_if<renderer::ButtonChanged>(&event)) {
    const auto index = static_cast<std::size_t>(button->button);
    if (button->down && !pointer_.down[index]) {
      pointer_.pressed[index] = true;
      pointer_.movement_px = {0.0F, 0.0F};  // a drag begins here, so earlier movement does not count
    }
    pointer_.down[index] = button->down;
  } else if (const auto* wheel = std::get_if<renderer::WheelTurned>(&event)) {
    pointer_.notches += static_cast<float>(wheel->y);
  } else if (const auto* resized = std::get_if<renderer::Resized>(&event)) {
    size_ = *resized;
  } else if (const auto* scaled = std::get_if<renderer::ScaleChanged>(&event)) {
    scale_ = scaled->scale;
    interface_.set_scale(scale_);
  } else if (const auto* dropped = std::get_if<renderer::FileDropped>(&event)) {
    state_.scene_asked = dropped->path;
  } else if (const auto* key = std::get_if<renderer::KeyChanged>(&event)) {
    take_key(*key);
  }
}

void Viewer::take_key(const renderer::KeyChanged& event) {
  const bool repeats = !event.down || !keys_down_.insert(event.key).second;
  if (!event.down) {
    keys_down_.erase(event.key);
    return;
  }
  const bool has_control = is_down(keys_down_, keys::left_control, keys::right_control);
  if (interface_.wants_keys() || is_down(keys_down_, keys::left_alt, keys::right_alt)) return;
  for (const KeyBinding& binding : key_bindings()) {
    const bool is_pressed = binding.key == event.key && binding.needs_control == has_control;
    if (binding.action && is_pressed && (!repeats || binding.repeats)) state_.asked.push_back(*binding.action);
  }
}

void Viewer::note_snapshot(SnapshotPtr newest) {
  const bool is_new_garment = !state_.newest || newest->loaded->generation != state_.newest->loaded->generation;
  const bool has_other_area = state_.newest && (newest->compared != nullptr) != (state_.newest->compared != nullptr);
  state_.newest = std::move(newest);
  if (is_new_garment) adopt_scene();
  for (const Notice& notice : *state_.newest->notices) {
    if (notice.number > told_notice_) {
      told_notice_ = notice.number;
      tell(notice.text, notice.is_error);
    }
  }
  note_measurements();
  choose_shown();
  if (is_new_garment || has_other_area) {
    state_.camera = OrbitCamera(first_camera());
    followed_m_ = glm::vec3(0.0F);
    follows_ = state_.scene.camera.follow;
  }
  follow();
}

// Moves the view with the shown garment. A view that begins to follow stays where it is.
void Viewer::follow() {
  const bool begins = state_.scene.camera.follow && !follows_;
  follows_ = state_.scene.camera.follow;
  const glm::vec3 before_m = std::exchange(followed_m_, followed_m(state_, *state_.shown));
  if (follows_ && !begins) state_.camera.move(followed_m_ - before_m);
}

void Viewer::adopt_scene() {
  state_.scene = state_.newest->loaded->scene;
  state_.motions = motion_choices(state_.scene, state_.motions);
  told_ = ChangeSettings(state_.scene);
  if (!opened_) opened_ = state_.scene;
  state_.past_frame.reset();
  hands_.drop();
  noted_frame_.reset();
  state_.measurements.forget();
}

// Returns a camera that fits the garment at its start, with space for its motion.
renderer::Camera Viewer::first_camera() const {
  const LoadedScene& loaded = *state_.newest->loaded;
  const ViewArea area = area_of_one();
  DrawnScene scene = state_.scene;
  scene.picture.settings.width_px = area.width_px;
  scene.picture.settings.height_px = area.height_px;
  if (is_fitted(scene)) {
    scene.camera.framing.margin = std::max(scene.camera.framing.margin, window_margin);
    FittedView fitted(scene, *loaded.garment, loaded.bodies.all);
    const std::vector<sim::Vec3>& positions = state_.newest->positions();
    fitted.add(positions, loaded.shown_m(positions), state_.newest->checkpoint->state.time_s);
    fitted.place_camera(scene);
  }
  return scene_camera(scene, expected_reach(scene, *loaded.garment, loaded.bodies.all, loaded.pins), area.aspect());
}

// Adds the measurements of all new frames, because the window may have missed some. After a return to an earlier frame
// the plots start again.
void Viewer::note_measurements() {
  const int newest = state_.newest->record.frame;
  constexpr int max_values = static_cast<int>(RecentValues::max_count);
  int first = noted_frame_ ? *noted_frame_ + 1 : newest;
  if (noted_frame_ && newest < *noted_frame_) {
    state_.measurements.forget();
    first = first_frame_in_reach(*state_.newest);
  }
  for (int frame = std::max(first, newest - max_values); frame <= newest; ++frame) {
    state_.measurements.add(simulation_.past_frame(state_.newest, frame)->record);
  }
  noted_frame_ = newest;
}

void Viewer::choose_shown() {
  state_.shown = state_.newest;
  if (state_.past_frame) {
    state_.past_frame =
        std::clamp(*state_.past_frame, first_frame_in_reach(*state_.newest), state_.newest->record.frame);
    state_.shown = within_present_bound(simulation_.past_frame(state_.newest, *state_.past_frame));
  }
}

SnapshotPtr Viewer::within_present_bound(const SnapshotPtr& past) {
  const sim::SolverSettings solver = solver_settings(state_.scene.simulation.solver);
  if (past == past_ && solver == past_bound_) return past_within_bound_;
  past_ = past_within_bound_ = past;
  past_bound_ = solver;
  if (solver != past->settings.solver) {
    const sim::Simulation simulation =
        continue_from(*past, simulation_settings(state_.scene.simulation), past->garment->material, past->surroundings);
    Snapshot snapshot = *past;
    measure_stretches(simulation, snapshot.record);
    snapshot.checkpoint = std::make_shared<const sim::Checkpoint>(simulation.save());
    snapshot.settings = simulation.settings();
    past_within_bound_ = std::make_shared<const Snapshot>(std::move(snapshot));
  }
  return past_within_bound_;
}

void Viewer::note_speed(std::uint64_t advances_before) {
  RealTime& real_time = state_.measurements.real_time;
  const double busy_s = std::exchange(busy_s_, 0.0);
  const int pictures = std::exchange(pictures_, 0);
  if (state_.newest->paused || has_stopped(*state_.newest)) return real_time.forget();
  const auto advances = static_cast<double>(state_.newest->advances - advances_before);
  real_time.add(elapsed_s_, advances / state_.scene.simulation.frame_rate_hz, busy_s, pictures);
}

// Two compared garments have labels of their own instead.
void Viewer::warn() {
  state_.warning = compared_garment(state_) != nullptr ? ""
                   : state_.newest->stopped && !state_.past_frame
                       ? "the simulation has stopped: R, any other setting or another scene starts again"
                       : lost_cloth(state_.shown->positions(), state_.shown->loaded->garment->mesh.triangles,
                                    state_.camera, area_of_one());
}

void Viewer::collect_settings() {
  if (ChangeSettings wanted(state_.scene); wanted != told_) {
    told_ = wanted;
    commands_.emplace_back(std::move(wanted));
  }
  if (state_.compared_with != told_compared_) {
    told_compared_ = state_.compared_with;
    state_.past_frame.reset();
    commands_.emplace_back(Compare{state_.compared_with});
  }
  if (state_.speed != told_speed_) {
    told_speed_ = state_.speed;
    commands_.emplace_back(SetSpeed{state_.speed});
  }
}

// Counts frames without change. The panel shows the effect of input one frame later, so it needs some frames to settle.
void Viewer::note_changes(const SessionFrame& frame) {
  for (Message& message : state_.messages) message.left_s -= frame.elapsed_s;
  const std::size_t gone = std::erase_if(state_.messages, [](const Message& message) { return message.left_s <= 0.0; });
  const bool is_changing = (!state_.paused && moves(*state_.newest)) || !frame.events.empty() || gone > 0 ||
                           hands_.is_busy() || recorder_ || is_hint_due(state_);
  frames_since_input_ = !frame.events.empty() || hands_.is_busy() ? 0 : frames_since_input_ + 1;
  still_frames_ = is_changing ? 0 : still_frames_ + 1;
}

void Viewer::note_times(double draw_ms, double panel_ms, double simulate_ms, double busy_s) {
  busy_s_ += busy_s;
  ++pictures_;
  // Single frames differ so much that the reason of a slow simulation would change with each.
  constexpr double newest_weight = 0.05;
  double& worked_ms = state_.measurements.worked_ms;
  worked_ms = worked_ms > 0.0 ? std::lerp(worked_ms, simulate_ms, newest_weight) : simulate_ms;
  state_.measurements.draw_ms.add(static_cast<float>(draw_ms));
  state_.measurements.panel_ms.add(static_cast<float>(panel_ms));
}

void Viewer::save_scene() {
  const std::filesystem::path file = free_name(keep_folder_, state_.scene.name, ".toml");
  DrawnScene scene = kept_scene(state_, area_of_one());
  if (!is_pristine(state_)) {
    const std::filesystem::path moment = free_name(keep_folder_, state_.scene.name, ".checkpoint");
    scene.checkpoint = moment.filename();
    write_run_checkpoint(moment, kept_moment(state_, scene));
  }
  write_text_file(file, scene_text(scene, GarmentNaming::full_path));
  tell(fmt::format("saved {}; taut render of it draws this frame", file.string()), false);
}

void Viewer::export_shape() {
  const std::filesystem::path file = free_name(keep_folder_, state_.scene.name, ".obj");
  const LoadedScene& loaded = *state_.shown->loaded;
  write_text_file(file, WrittenCloth(loaded).obj(loaded.shown_m(state_.shown->positions())));
  tell("wrote " + file.string() + ", in metres with y up", false);
}

void Viewer::start_or_stop_recording() {
  if (recorder_) {
    finish_recording();
    return;
  }
  const ViewArea area = scene_area(layout());
  recorder_.emplace(keep_folder_, state_.scene.name, area.width_px, area.height_px);
  state_.is_recording = true;
  tell("recording; F10 ends it", false);
}

std::optional<std::string> Viewer::finish_recording() {
  if (!recorder_) return std::nullopt;
  state_.is_recording = false;
  std::string outcome;
  const std::string error = attempt([&] { outcome = recorder_->finish(); });
  recorder_.reset();
  if (!error.empty()) return error;
  tell(outcome, false);
  return outcome;
}

void Viewer::take_picture(const renderer::Image& picture) {
  if (std::exchange(screenshot_, false)) {
    attempt([&] {
      const std::filesystem::path file = free_name(keep_folder_, state_.scene.name, ".png");
      write_file(file, renderer::encode_png(picture));
      tell("wrote " + file.string(), false);
    });
  }
  if (recorder_ && !attempt([&] { recorder_->add(picture, elapsed_s_); }).empty()) finish_recording();
}

}  // namespace taut::app
