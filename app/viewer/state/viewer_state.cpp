#include "app/viewer/state/viewer_state.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/bodies/motion_opening.hpp"
#include "renderer/context/window.hpp"

namespace taut::app {
namespace {

// Time constant of the averages of RealTime. A larger value is steadier and reacts more slowly.
constexpr double memory_s = 1.0;
// RealTime::factor says nothing before this much real time.
constexpr double first_moments_s = 0.5;
// Fraction of the speed asked for, or of the time a frame may take, that counts as all of it.
constexpr double as_good_as_asked = 0.95;
// Share of the processors' time above which this program itself is the reason.
constexpr double most_of_it = 0.75;

// How long messages are shown. Errors stay longer.
constexpr double short_message_s = 4.0;
constexpr double error_message_s = 12.0;
// With more messages the oldest disappears.
constexpr std::size_t most_messages = 4;

namespace fs = std::filesystem;

// Of "tshirt_10600": "tshirt_" and 10600; 0 without a number.
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

constexpr std::array<KeyBinding, 31> bindings = {{
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
    {"J, K", "let go the left, the right corner", 'J', Action::release_left},
    {"", "", 'K', Action::release_right},
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

void RecentValues::add(float value) {
  if (values_.size() == most) values_.erase(values_.begin());
  values_.push_back(value);
}

void RealTime::add(double elapsed_s, double simulated_s, double busy_s, int pictures) {
  const double kept = std::exp(-elapsed_s / memory_s);
  elapsed_s_ = kept * elapsed_s_ + elapsed_s;
  simulated_s_ = kept * simulated_s_ + simulated_s;
  busy_s_ = kept * busy_s_ + busy_s;
  pictures_ = kept * pictures_ + pictures;
}

std::optional<double> RealTime::factor() const {
  return elapsed_s_ > first_moments_s ? std::optional(simulated_s_ / elapsed_s_) : std::nullopt;
}

double RealTime::busy_share() const { return elapsed_s_ > 0.0 ? busy_s_ / elapsed_s_ : 0.0; }

SlowedBy slowed_by(double factor, double asked, double simulate_ms, double frame_ms, double busy_share) {
  if (factor >= as_good_as_asked * asked) return SlowedBy::nothing;
  if (simulate_ms >= as_good_as_asked * frame_ms) return SlowedBy::simulation;
  return busy_share >= most_of_it ? SlowedBy::drawing : SlowedBy::other_programs;
}

const Choice* coarser_than(const std::string& name, std::span<const Choice> garments) {
  const auto [kind, triangles] = kind_and_number(name);
  const Choice* best = nullptr;
  int most = 0;
  for (const Choice& choice : garments) {
    const auto [other, count] = kind_and_number(choice.name);
    if (other != kind || count >= triangles || count <= most) continue;
    best = &choice;
    most = count;
  }
  return best;
}

std::string in_little_room(double value, int decimals) {
  return std::abs(value) < 1e5 ? fmt::format("{:.{}f}", value, decimals) : fmt::format("{:.1e}", value);
}

std::string other_stretches(const FrameRecord& record, sim::BoundKind plotted) {
  const auto percent = [](double stretch) { return in_little_room(100.0 * stretch, 2); };
  const bool plots_springs = plotted == sim::BoundKind::springs;
  const double p99 = plots_springs ? record.stretch.p99 : record.surface_stretch.p99;
  const double other = plots_springs ? record.surface_stretch.max : record.stretch.max;
  const double other_p99 = plots_springs ? record.surface_stretch.p99 : record.stretch.p99;
  return fmt::format("p99 {} %, {} {} %, p99 {} %", percent(p99), plots_springs ? "surface" : "springs", percent(other),
                     percent(other_p99));
}

std::string contact_text(const sim::ContactReport& contact) {
  const std::string nearest = std::isfinite(contact.smallest_distance_m)
                                  ? "nearest " + in_little_room(1000.0 * contact.smallest_distance_m, 2) + " mm"
                                  : std::string("nothing near");
  return contact.left_out_share > 0.0
             ? fmt::format("{}, {} pairs cross, {:.1f} % left out", nearest, contact.crossing_pairs,
                           100.0 * contact.left_out_share)
             : fmt::format("{}, {}", nearest, counted(contact.crossing_pairs, "pair crosses", "pairs cross"));
}

void Measurements::add(const FrameRecord& record) {
  constexpr double mm_per_m = 1000.0;
  max_stretch.add(static_cast<float>(record.stretch.max));
  max_surface_stretch.add(static_cast<float>(record.surface_stretch.max));
  convergence_mm.add(static_cast<float>(record.convergence_m * mm_per_m));
  simulate_ms.add(static_cast<float>(record.sim_ms));
}

void Measurements::forget() {
  for (RecentValues* values : {&max_stretch, &max_surface_stretch, &convergence_mm, &simulate_ms}) {
    values->clear();
  }
}

const Snapshot* compared(const ViewerState& state) {
  return state.newest->compared ? state.shown->compared.get() : nullptr;
}

const char* solver_of(const Snapshot& garment) { return sim::name_of(sim::kind_of(garment.settings.solver.method)); }

const char* slower_solver(const Snapshot& newest) {
  const bool is_second = newest.compared && newest.compared->record.sim_ms > newest.record.sim_ms;
  return solver_of(is_second ? *newest.compared : newest);
}

const Snapshot& pointed_at(const ViewerState& state) {
  const Snapshot* second = state.at_compared ? compared(state) : nullptr;
  return second != nullptr ? *second : *state.shown;
}

void tell(ViewerState& state, const std::string& text, bool is_error) {
  std::erase_if(state.messages, [&](const Message& old) { return old.text == text; });
  if (state.messages.size() >= most_messages) state.messages.erase(state.messages.begin());
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
  std::vector<Choice> choices;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(assets_folder() / folder, error)) {
    if (entry.path().extension() == ending) {
      choices.push_back({entry.path().stem().string(), "", entry.path()});
    }
  }
  std::ranges::sort(choices, {},
                    [](const Choice& choice) { return std::pair(kind_and_number(choice.name), choice.name); });
  return choices;
}

MotionChoices motion_choices(const DrawnScene& scene, const MotionChoices& known) {
  for (std::size_t body = 0; body < scene.body_sources.size(); ++body) {
    const BodySource& source = scene.body_sources[body];
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

DrawnScene with_motion(const DrawnScene& scene, std::size_t body, const Choice& motion,
                       std::vector<std::string>& remarks) {
  DrawnScene moved = scene;
  moved.checkpoint.clear();
  BodySource& source = moved.body_sources.at(body);
  source = moved_by(source, motion);
  std::get<sim::BodyMesh>(moved.surroundings.bodies.at(body).shape) = {};
  try {
    remarks = load_bodies(moved);
  } catch (const InputError&) {
    source.loop = false;
    remarks = load_bodies(moved);
  }
  return moved;
}

std::span<const KeyBinding> key_bindings() { return bindings; }

}  // namespace taut::app
