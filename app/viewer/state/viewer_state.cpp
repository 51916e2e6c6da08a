#include "app/viewer/state/viewer_state.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/drawing/framing.hpp"
#include "renderer/context/window.hpp"

namespace taut::app {
namespace {

// Largest elevation. At 90 degrees the up direction is undefined.
constexpr float max_elevation_rad = glm::radians(89.0F);
// Smallest distance to the target.
constexpr float min_distance_m = 0.01F;
// Factor on the distance for each notch of the wheel.
constexpr float zoom_factor = 0.88F;
// Fraction of the picture that `fit` leaves free around the box.
constexpr float fit_margin = 0.06F;

// Returns a bit for each side of the camera's view volume that a point is beyond. A point that is not finite is beyond
// all of them.
unsigned sides_beyond(const sim::Vec3& position, const glm::dmat4& to_clip) {
  const glm::dvec4 clip = to_clip * glm::dvec4(position, 1.0);
  unsigned sides = 0;
  for (const int axis : {0, 1, 2}) {
    sides = sides << 2U | (clip[axis] >= -clip.w ? 0U : 1U) | (clip[axis] <= clip.w ? 0U : 2U);
  }
  return sides;
}

// Time constant of the averages of RealTime. A larger value is steadier and reacts more slowly.
constexpr double averaging_time_s = 1.0;
// Real time before which RealTime::factor is empty.
constexpr double first_moments_s = 0.5;
// Fraction of the requested speed, or of the available time, that counts as fast enough.
constexpr double sufficient_fraction = 0.95;
// Fraction of the processors' time above which this program itself is the reason.
constexpr double max_share = 0.75;

// Display times of messages. Errors stay longer.
constexpr double short_message_s = 4.0;
constexpr double error_message_s = 12.0;
// Maximum number of messages; the oldest disappears.
constexpr std::size_t max_messages = 4;

namespace fs = std::filesystem;

// Splits "tshirt_10600" into "tshirt_" and 10600; 0 if there is no number.
std::pair<std::string, int> kind_and_number(const std::string& name) {
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  const bool is_of_kind = digits > 0 && name[digits - 1] == '_';
  return {name.substr(0, digits), is_of_kind ? number_in<int>(name.substr(digits)).value_or(0) : 0};
}

BodySource moved_by(BodySource source, const Choice& motion) {
  source.motion = motion.file;
  source.clip = motion.file.empty() ? motion.name : "";
  source.frame_rate_hz.reset();
  source.start_s = 0.0;
  source.loop = true;
  return source;
}

bool fits(const BodySource& source, const std::shared_ptr<const Rig>& rig, const Choice& motion) {
  try {
    open_motion(moved_by(source, motion), rig, ModelAxis::y);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::vector<Choice> choices_for(const BodySource& source, const std::shared_ptr<const Rig>& rig) {
  std::vector<Choice> choices = files_in("motions", ".bvh");
  for (Choice& motion : choices) {
    motion.label = motion.name;
    std::ranges::replace(motion.label, '_', ' ');
  }
  for (const std::string& clip : names_of_clips(*rig)) choices.push_back({clip, clip + " (its own)", ""});
  std::erase_if(choices, [&](const Choice& motion) { return !fits(source, rig, motion); });
  return choices;
}

namespace keys = renderer::keys;

constexpr std::array<KeyBinding, 29> bindings = {{
    {"Left drag", "on cloth: pull it; elsewhere: orbit"},
    {"Right drag", "move the view"},
    {"Wheel", "nearer to what is under the pointer, farther"},
    {"Up, Down", "more wind, less wind", keys::up, Action::more_wind, true},
    {"", "", keys::down, Action::less_wind, true},
    {"Left, Right", "turn the wind", keys::left, Action::turn_wind_left, true},
    {"", "", keys::right, Action::turn_wind_right, true},
    {"Space", "pause, go on", keys::space, Action::pause},
    {".", "one frame", keys::period, Action::step, true},
    {"Time bar", "back in time; Space goes on from there"},
    {"R", "start again, with the scene's pins", 'R', Action::reset},
    {"P", "pin or free the cloth under the pointer", 'P', Action::toggle_pin},
    {"F", "look at the whole garment", 'F', Action::show_whole_garment},
    {"1, 3, 7, 9", "from the front, the side, behind, three quarters", '1', Action::see_front},
    {"", "", '3', Action::see_side},
    {"", "", '7', Action::see_back},
    {"", "", '9', Action::see_three_quarters},
    {"PgUp, PgDn", "the scene before, the next one", keys::page_up, Action::previous_scene},
    {"", "", keys::page_down, Action::next_scene},
    {"F12", "picture of the scene, without the panel", keys::f12, Action::screenshot},
    {"F10", "record the scene, stop recording", keys::f10, Action::record},
    {"S", "save the settings as a scene file", 'S', Action::save_scene},
    {"E", "export the cloth as it is, as OBJ", 'E', Action::export_shape},
    {"Tab", "panel on, off", keys::tab, Action::show_panel},
    {"H", "this sheet", 'H', Action::show_keys},
    {"Esc", "close a list, or this sheet", keys::escape, Action::close_keys},
    {"Ctrl + Q", "end", 'Q', Action::quit, false, true},
    {"Ctrl + click", "on a number: type it"},
    {"Drop a file", "a model, a scene file or a picture: load it"},
}};

}  // namespace

OrbitCamera::OrbitCamera(const renderer::Camera& camera)
    : target_(camera.target), vertical_fov_rad_(camera.vertical_fov_rad) {
  const glm::vec3 back = camera.eye - camera.target;
  const float distance_m = glm::length(back);
  distance_m_ = std::clamp(distance_m, min_distance_m, max_distance_m);
  elevation_rad_ =
      std::clamp(std::asin(std::clamp(back.y / distance_m, -1.0F, 1.0F)), -max_elevation_rad, max_elevation_rad);
  azimuth_rad_ = std::atan2(back.x, back.z);
}

void OrbitCamera::orbit(const glm::vec2& way_px, const ViewArea& area) {
  const float rad_per_px = std::numbers::pi_v<float> / static_cast<float>(std::max(area.height_px, 100));
  azimuth_rad_ = std::remainder(azimuth_rad_ - way_px.x * rad_per_px, 2.0F * std::numbers::pi_v<float>);
  elevation_rad_ = std::clamp(elevation_rad_ + way_px.y * rad_per_px, -max_elevation_rad, max_elevation_rad);
}

void OrbitCamera::turn_to(float azimuth_rad, float elevation_rad) {
  azimuth_rad_ = azimuth_rad;
  elevation_rad_ = std::clamp(elevation_rad, -max_elevation_rad, max_elevation_rad);
}

void OrbitCamera::pan(const glm::vec2& way_px, const ViewArea& area) {
  const glm::mat3 axes = glm::transpose(glm::mat3(camera().view()));  // right, up and towards the eye
  const float m_per_px =
      2.0F * distance_m_ * std::tan(0.5F * vertical_fov_rad_) / static_cast<float>(std::max(area.height_px, 1));
  move_target(target_ + m_per_px * (axes[1] * way_px.y - axes[0] * way_px.x));
}

void OrbitCamera::move_target(const glm::vec3& target) {
  target_ = glm::clamp(target, glm::vec3(-max_distance_m), glm::vec3(max_distance_m));
}

// Moving the eye along the ray through the pixel keeps all points of the ray there.
void OrbitCamera::zoom(float notches, const glm::vec2& point_px, const ViewArea& area) {
  const float before_m = distance_m_;
  const Ray ray = ray_through(point_px, area);
  distance_m_ = std::clamp(distance_m_ * std::pow(zoom_factor, std::clamp(notches, -50.0F, 50.0F)), min_distance_m,
                           max_distance_m);
  const glm::vec3 forward = glm::normalize(target_ - ray.origin);
  const glm::vec3 under = ray.origin + ray.direction * (before_m / glm::dot(ray.direction, forward));
  move_target(under + (distance_m_ / before_m) * (target_ - under));
}

void OrbitCamera::fit(const renderer::Box& box, const ViewArea& area) {
  const renderer::Camera framed =
      renderer::fit_camera_to_box(box, {azimuth_rad_, elevation_rad_, vertical_fov_rad_, fit_margin}, area.aspect());
  move_target(framed.target);
  distance_m_ = std::clamp(glm::distance(framed.eye, framed.target), min_distance_m, max_distance_m);
}

renderer::Camera OrbitCamera::camera() const {
  const float flat = std::cos(elevation_rad_);
  const glm::vec3 back{flat * std::sin(azimuth_rad_), std::sin(elevation_rad_), flat * std::cos(azimuth_rad_)};
  // camera_at() gives the same camera for a scene with camera.eye, so a saved scene gives the same picture.
  return camera_at(target_ + distance_m_ * back, target_, vertical_fov_rad_);
}

Ray OrbitCamera::ray_through(const glm::vec2& point_px, const ViewArea& area) const {
  const renderer::Camera seen = camera();
  const glm::mat3 axes = glm::transpose(glm::mat3(seen.view()));  // right, up and towards the eye
  const float tangent = std::tan(0.5F * vertical_fov_rad_);
  const float x = (2.0F * point_px.x / static_cast<float>(area.width_px) - 1.0F) * tangent * area.aspect();
  const float y = (1.0F - 2.0F * point_px.y / static_cast<float>(area.height_px)) * tangent;
  return {seen.eye, glm::normalize(-axes[2] + x * axes[0] + y * axes[1])};
}

std::optional<glm::vec2> OrbitCamera::project_to_pixel(const glm::vec3& point, const ViewArea& area) const {
  const renderer::Camera seen = camera();
  const glm::vec4 clip = seen.projection(area.aspect()) * seen.view() * glm::vec4(point, 1.0F);
  if (!(clip.w > 0.0F)) return std::nullopt;
  return glm::vec2{(0.5F + 0.5F * clip.x / clip.w) * static_cast<float>(area.width_px),
                   (0.5F - 0.5F * clip.y / clip.w) * static_cast<float>(area.height_px)};
}

std::optional<glm::dvec3> drag_point(const Ray& ray, const glm::dvec3& through, const renderer::Camera& camera) {
  const glm::dvec3 facing(glm::normalize(camera.target - camera.eye));
  const glm::dvec3 origin(ray.origin);
  const glm::dvec3 direction(ray.direction);
  const double slant = glm::dot(direction, facing);
  const double distance = glm::dot(through - origin, facing) / slant;
  if (!(slant > 1e-6) || !std::isfinite(distance) || distance <= 0.0) return std::nullopt;
  return origin + distance * direction;
}

std::string lost_cloth(std::span<const sim::Vec3> positions, std::span<const sim::Triangle> triangles,
                       const OrbitCamera& camera, const ViewArea& area) {
  const renderer::Camera seen = camera.camera();
  const glm::dmat4 to_clip(seen.projection(area.aspect()) * seen.view());
  // Tests triangles instead of vertices: a near triangle may fill the picture while its corners are outside.
  const bool is_seen = std::ranges::any_of(triangles, [&](const sim::Triangle& triangle) {
    const auto beyond = [&](int corner) { return sides_beyond(positions[triangle[corner]], to_clip); };
    return (beyond(0) & beyond(1) & beyond(2)) == 0U;
  });
  if (is_seen) return "";
  const bool is_in_reach = std::ranges::any_of(positions, [](const sim::Vec3& position) {
    const auto is_near = [](double coordinate) { return std::abs(coordinate) < OrbitCamera::max_distance_m; };
    return is_near(position.x) && is_near(position.y) && is_near(position.z);
  });
  return is_in_reach ? "the cloth has left the picture: F looks at it, R starts again"
                     : "the cloth has left the world: R starts again";
}

void RecentValues::add(float value) {
  if (values_.size() == max_count) values_.erase(values_.begin());
  values_.push_back(value);
}

void RealTime::add(double elapsed_s, double simulated_s, double busy_s, int pictures) {
  const double decay = std::exp(-elapsed_s / averaging_time_s);
  elapsed_s_ = decay * elapsed_s_ + elapsed_s;
  simulated_s_ = decay * simulated_s_ + simulated_s;
  busy_s_ = decay * busy_s_ + busy_s;
  pictures_ = decay * pictures_ + pictures;
}

std::optional<double> RealTime::factor() const {
  return elapsed_s_ > first_moments_s ? std::optional(simulated_s_ / elapsed_s_) : std::nullopt;
}

SlowedBy find_slowdown(double factor, double asked, double simulate_ms, double frame_ms, double busy_share) {
  if (factor >= sufficient_fraction * asked) return SlowedBy::nothing;
  if (simulate_ms >= sufficient_fraction * frame_ms) return SlowedBy::simulation;
  return busy_share >= max_share ? SlowedBy::drawing : SlowedBy::other_programs;
}

std::string short_number(double value, int decimals) {
  return std::abs(value) < 1e5 ? fmt::format("{:.{}f}", value, decimals) : fmt::format("{:.1e}", value);
}

glm::vec3 followed_m(const ViewerState& state, const Snapshot& garment) {
  if (!state.scene.camera.follow) return glm::vec3(0.0F);
  return mean_position(garment.positions()) - mean_position(garment.loaded->garment->mesh.positions);
}

renderer::Camera camera_at_rest(const ViewerState& state, const Snapshot& garment) {
  renderer::Camera camera = state.camera.camera();
  const glm::vec3 shift = followed_m(state, garment);
  camera.eye -= shift;
  camera.target -= shift;
  return camera;
}

std::string other_stretches(const FrameRecord& record, sim::BoundKind plotted) {
  const auto percent = [](double stretch) { return short_number(100.0 * stretch, 2); };
  const bool plots_springs = plotted == sim::BoundKind::springs;
  return fmt::format("largest of {} {} %\n99 of 100: surface {} %, springs {} %",
                     plots_springs ? "the surface" : "springs",
                     percent(plots_springs ? record.surface_stretch.max : record.stretch.max),
                     percent(record.surface_stretch.p99), percent(record.stretch.p99));
}

std::string contact_text(const sim::ContactReport& contact) {
  const std::string distance_text = std::isfinite(contact.min_distance_m)
                                        ? "nearest " + short_number(1000.0 * contact.min_distance_m, 2) + " mm"
                                        : std::string("nothing near");
  return contact.excluded_area_fraction > 0.0
             ? fmt::format("{}, {} pairs cross, {:.1f} % left out", distance_text, contact.crossing_pairs,
                           100.0 * contact.excluded_area_fraction)
             : fmt::format("{}, {}", distance_text, count_text(contact.crossing_pairs, "pair crosses", "pairs cross"));
}

void Measurements::add(const FrameRecord& record) {
  constexpr double mm_per_m = 1000.0;
  max_stretch.add(static_cast<float>(record.stretch.max));
  max_surface_stretch.add(static_cast<float>(record.surface_stretch.max));
  convergence_mm.add(static_cast<float>(record.convergence_m * mm_per_m));
  simulate_ms.add(static_cast<float>(record.sim_ms));
}

void Measurements::forget() {
  for (RecentValues* values : {&max_stretch, &max_surface_stretch, &convergence_mm, &simulate_ms}) values->clear();
}

const Snapshot* compared_garment(const ViewerState& state) {
  return state.newest->compared ? state.shown->compared.get() : nullptr;
}

const char* solver_name(const Snapshot& garment) {
  return sim::to_name(sim::solver_kind(garment.settings.solver.method));
}

const char* slower_solver(const Snapshot& newest) {
  const bool is_second = newest.compared && newest.compared->record.sim_ms > newest.record.sim_ms;
  return solver_name(is_second ? *newest.compared : newest);
}

const Snapshot& pointed_at(const ViewerState& state) {
  const Snapshot* second = state.is_over_second ? compared_garment(state) : nullptr;
  return second != nullptr ? *second : *state.shown;
}

void tell(ViewerState& state, const std::string& text, bool is_error) {
  std::erase_if(state.messages, [&](const Message& old) { return old.text == text; });
  if (state.messages.size() >= max_messages) state.messages.erase(state.messages.begin());
  state.messages.push_back({text, is_error, is_error ? error_message_s : short_message_s});
}

std::vector<Choice> scene_choices() {
  std::vector<Choice> choices;
  std::size_t count_without_contact = 0;
  for (const BuiltInScene& scene : built_in_scenes()) {
    try {
      choices.push_back({scene.name, read_scene_file(scene.file).title, scene.file});
      count_without_contact += scene.is_of_contact ? 0 : 1;
    } catch (const InputError&) {
      continue;
    }
  }
  std::stable_sort(choices.begin(), choices.begin() + static_cast<std::ptrdiff_t>(count_without_contact),
                   [](const Choice& a, const Choice& b) { return a.label < b.label; });
  return choices;
}

std::vector<Choice> files_in(const std::string& folder, const std::string& ending) {
  auto choices = collect<Choice>(list_files(assets_folder() / folder, ending), [](const fs::path& file) {
    return Choice{file.stem().string(), "", file};
  });
  std::ranges::sort(choices, {},
                    [](const Choice& choice) { return std::pair(kind_and_number(choice.name), choice.name); });
  return choices;
}

MotionChoices motion_choices(const DrawnScene& scene, const MotionChoices& known) {
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    const BodySource& source = scene.bodies[body].source;
    if (source.file.empty()) continue;
    if (source.file == known.of) return {body, known.of, known.choices};
    try {
      const std::shared_ptr<const Rig> rig = read_rig(source.file);
      if (!rig->influences.empty()) return {body, source.file, choices_for(source, rig)};
    } catch (const InputError&) {
      continue;
    }
  }
  return {};
}

bool is_chosen(const Choice& motion, const BodySource& source) {
  return motion.file.empty() ? source.motion.empty() && source.clip == motion.name
                             : source.motion.lexically_normal() == motion.file.lexically_normal();
}

void set_motion(std::size_t body, const Choice& motion, SceneWithBodies& shown) {
  shown.scene.checkpoint.clear();
  BodySource& source = shown.scene.bodies.at(body).source;
  source = moved_by(source, motion);
  try {
    shown.bodies = reload_body(shown.scene, body, shown.bodies);
  } catch (const InputError&) {
    source.loop = false;
    shown.bodies = reload_body(shown.scene, body, std::move(shown.bodies));
  }
}

std::span<const KeyBinding> key_bindings() { return bindings; }

}  // namespace taut::app
