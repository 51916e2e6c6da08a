#include "app/bodies/body_loading.hpp"
#include "app/drawing/framing.hpp"
#include "app/garments/sewing/sewing.hpp"
#include "app/models/hanging/hanger.hpp"
#include "app/output/picture_record.hpp"
#include "app/viewer/viewer.hpp"

// Actions of the viewer's keys and buttons.

namespace taut::app {
namespace {

using renderer::PointerButton;

// Changes by one press of a key.
constexpr double wind_step_m_per_s = 0.5;
constexpr double turn_step_rad = 0.08726646259971647;  // 5 degrees

/// Returns the same name for tshirt_10600 and tshirt_5280: both are the same garment, with the same seams to hang from.
std::filesystem::path file_kind(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  return file.parent_path() / stem.substr(0, stem.find('_'));
}

void take_garment(const std::filesystem::path& file, SceneWithBodies& asked) {
  DrawnScene& scene = asked.scene;
  if (file_kind(scene.garment.file) != file_kind(file)) {
    scene.pins.reset();
    scene.camera = {};
    scene.picture.ground = {};
  }
  take_off_hanger(scene, asked.bodies.all);
  scene.garment.file = file;
  scene.garment.start.clear();
  scene.garment.sewn.clear();
}

}  // namespace

std::string Viewer::attempt(const std::function<void()>& work) {
  try {
    work();
    return "";
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    tell(error.what(), true);
    return error.what();
  }
}

void Viewer::perform(Action action) {
  const auto ask = [this](SimulationCommand command) { commands_.emplace_back(std::move(command)); };
  const auto step = [&] {
    pause(true);
    go_on_from_shown();
    ask(StepOnce{});
  };
  const auto reset = [&] {
    state_.past_frame.reset();
    ask(Reset{});
  };
  const std::map<Action, std::function<void()>> work = {
      {Action::pause, [&] { pause(!state_.paused); }},
      {Action::step, step},
      {Action::reset, reset},
      {Action::more_wind, [&] { change_wind(wind_step_m_per_s); }},
      {Action::less_wind, [&] { change_wind(-wind_step_m_per_s); }},
      {Action::turn_wind_left, [&] { turn_wind(turn_step_rad); }},
      {Action::turn_wind_right, [&] { turn_wind(-turn_step_rad); }},
      {Action::toggle_pin, [&] { toggle_pin(); }},
      {Action::show_whole_garment, [&] { show_whole_garment(); }},
      {Action::see_front, [&] { see_from(sides[0]); }},
      {Action::see_side, [&] { see_from(sides[1]); }},
      {Action::see_back, [&] { see_from(sides[2]); }},
      {Action::see_three_quarters, [&] { see_from(sides[3]); }},
      {Action::screenshot, [&] { screenshot_ = true; }},
      {Action::record, [&] { start_or_stop_recording(); }},
      {Action::save_scene, [&] { save_scene(); }},
      {Action::export_shape, [&] { export_shape(); }},
      {Action::show_keys, [&] { state_.show_keys = !state_.show_keys; }},
      {Action::close_keys, [&] { state_.show_keys = false; }},
      {Action::show_panel, [&] { state_.show_panel = !state_.show_panel; }},
      {Action::previous_scene, [&] { ask_for_scene_beside(-1); }},
      {Action::next_scene, [&] { ask_for_scene_beside(1); }},
      {Action::quit, [&] { is_ended_ = true; }}};
  work.at(action)();
}

void Viewer::pause(bool paused) {
  if (paused != state_.paused) {
    state_.paused = paused;
    commands_.emplace_back(SetPaused{paused});
  }
  if (!paused) go_on_from_shown();
}

void Viewer::go_on_from_shown() {
  if (state_.past_frame && state_.shown != state_.newest) commands_.emplace_back(GoBack{state_.shown});
  state_.past_frame.reset();
}

void Viewer::change_wind(double by_m_per_s) {
  double& speed = state_.scene.surroundings.forces.wind.speed_m_per_s;
  const double stepped = std::round((speed + by_m_per_s) / wind_step_m_per_s) * wind_step_m_per_s;
  speed = std::clamp(stepped, 0.0, std::max(strongest_wind_m_per_s, speed));
}

void Viewer::turn_wind(double by_rad) {
  glm::dvec3& direction = state_.scene.surroundings.forces.wind.direction;
  const double c = std::cos(by_rad);
  const double s = std::sin(by_rad);
  direction = {c * direction.x + s * direction.z, direction.y, c * direction.z - s * direction.x};
}

// Returns the pointer over its half of the scene; both halves show the same view. A drag stays in the half where it
// began.
Pointer Viewer::pointer_over_one() {
  const auto width_px = static_cast<float>(area_of_one().width_px);
  const auto drags = [&](PointerButton button) { return pointer_.is_down(button) && !pointer_.was_pressed(button); };
  if (!drags(PointerButton::left) && !drags(PointerButton::right) && !drags(PointerButton::middle)) {
    state_.is_over_second = compared_garment(state_) != nullptr && pointer_.position_px.x >= width_px;
  }
  Pointer over_one = pointer_;
  over_one.position_px.x -= state_.is_over_second ? width_px : 0.0F;
  return over_one;
}

void Viewer::toggle_pin() {
  const auto picked = cloth_under(pointer_over_one().position_px, area_of_one(), state_, pointed_at(state_));
  if (state_.shown != state_.newest) {
    tell("this is past: Space goes on from here, then P pins", false);
  } else if (picked) {
    commands_.emplace_back(TogglePin{picked->vertex});
  } else {
    tell("P pins the cloth under the pointer; there is none", false);
  }
}

void Viewer::show_whole_garment() {
  std::vector<sim::Vec3> positions = state_.shown->positions();
  if (const Snapshot* second = compared_garment(state_); second != nullptr && !second->stopped) {
    positions.insert(positions.end(), second->positions().begin(), second->positions().end());
  }
  state_.camera.fit(renderer::bounding_box(to_float(positions)), area_of_one());
}

void Viewer::see_from(const ViewSide& side) {
  state_.camera.turn_to(glm::radians(static_cast<float>(side.azimuth_deg)),
                        glm::radians(static_cast<float>(side.elevation_deg)));
  show_whole_garment();
}

void Viewer::choose_fabric(const std::string& name) {
  DrawnScene& scene = state_.scene;
  if (!name.empty()) {
    apply_overrides(std::vector<Override>{{"cloth.fabric", name, "fabric " + name}}, scene);
  } else if (opened_) {
    scene.fabric = opened_->fabric;
    scene.material = opened_->material;
    scene.picture.cloth = opened_->picture.cloth;
  }
}

// Asks for the next or previous scene in the list. After a scene that is not in the list comes the first one.
void Viewer::ask_for_scene_beside(std::ptrdiff_t by) {
  const auto count = std::ssize(state_.scenes);
  const auto own = std::ranges::find(state_.scenes, state_.scene.name, &Choice::name) - state_.scenes.begin();
  if (count > 0) state_.scene_asked = state_.scenes[static_cast<std::size_t>((own + by + count) % count)].name;
}

// Reads scenes on this thread, which takes milliseconds. The simulation loads the garment.
void Viewer::load_asked() {
  const std::optional<std::string> name = std::exchange(state_.scene_asked, std::nullopt);
  const auto garment = std::exchange(state_.garment_asked, std::nullopt);
  const auto motion = std::exchange(state_.motion_asked, std::nullopt);
  const auto fabric = std::exchange(state_.fabric_asked, std::nullopt);
  attempt([&] {
    if (fabric) choose_fabric(*fabric);
    if (!name && !motion && !garment) return;
    SceneWithBodies asked = {state_.scene, state_.newest->loaded->bodies};
    if (name) {
      asked.scene = is_picture(*name) ? read_picture_record(*name, {}).scene : find_scene(*name, {});
      asked.bodies = sew_and_load_bodies(asked.scene);
      opened_.reset();
    } else if (motion) {
      set_motion(state_.motions.body, *motion, asked);
    } else {
      take_garment(*garment, asked);
      asked.bodies.remarks = sew_garment(asked.scene);
    }
    for (const std::string& remark : asked.bodies.remarks) tell(remark, false);
    tell("loading " + asked.scene.name, false);
    commands_.emplace_back(LoadScene{std::make_shared<const SceneWithBodies>(std::move(asked))});
  });
}

}  // namespace taut::app
