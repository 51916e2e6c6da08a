#include "app/viewer/simulation/live_simulation.hpp"

#include "app/base/errors.hpp"
#include "app/base/progress.hpp"
#include "app/base/words.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/models/inspecting/remarks.hpp"
#include "app/models/mending/model_fitting.hpp"
#include "app/runs/run_checkpoint.hpp"

namespace taut::app {
namespace {

constexpr std::size_t max_bytes = 288U << 20U;
constexpr int min_frames = 30;
// Number of snapshots that the window may be behind the newest without losing any of the promised past.
constexpr int max_window_delay = 120;
constexpr int drop_interval = 16;
// Bytes per vertex of a checkpoint while cloth moves: three arrays of positions, and the correction of the last frame.
constexpr std::size_t vertex_bytes = 3 * sizeof(sim::Vec3) + 3 * sizeof(float);

int reach_frames(const Snapshot& newest) {
  const double rate_hz = newest.loaded->scene.simulation.frame_rate_hz;
  const auto by_time = static_cast<int>(std::min(Timeline::span_s * rate_hz, 1e6));
  const std::size_t garments = newest.compared ? 2 : 1;
  const std::size_t frame_bytes = std::max<std::size_t>(1, garments * newest.positions().size() * vertex_bytes);
  const auto by_memory = static_cast<int>(std::min<std::size_t>(max_bytes / frame_bytes, 1000000));
  return std::max(min_frames, std::min(by_time, by_memory));
}

// Returns true if a snapshot belongs to the past of a later one. A frame with several snapshots gives only its last.
bool led_to(const Snapshot& older, const Snapshot& later) {
  return older.loaded->generation == later.loaded->generation && older.record.frame < later.record.frame;
}

// Radius of cloth between the fingers. A smaller value pulls the cloth out to a point, a larger one lifts a stiff
// plate.
constexpr double grip_radius_m = 0.03;
// Angular frequency of a garment that hangs only from the hand's spring. A higher value follows the pointer more
// closely and jerks more.
constexpr double swing_rad_per_s = 60.0;
// Maximum pull in weights of the garment on Earth. A larger value pulls a pinned garment harder against its stretch
// bound.
constexpr double max_pull_weights = 5.0;
constexpr double earth_m_per_s2 = 9.81;
constexpr double arm_speed_m_per_s = 4.0;

// Returns the radius of a grip. On a coarse mesh it reaches at least the nearest vertices.
double reach_around(const sim::Garment& garment, sim::Index vertex) {
  double min_length_m = grip_radius_m;
  for (const sim::Index e : garment.adjacency.vertex_edges[vertex]) {
    const sim::Index other = sim::other_end(garment.adjacency.edges[e], vertex);
    const double length_m = glm::distance(garment.mesh.positions[vertex], garment.mesh.positions[other]);
    min_length_m = std::max(min_length_m, 1.05 * length_m);
  }
  return min_length_m;
}

std::shared_ptr<const LoadedScene> load(const SceneWithBodies& asked, std::uint64_t generation) {
  LoadedGarment loaded = load_garment(asked.scene);
  SceneWithBodies hung = asked;
  put_where_it_begins(loaded, hung.scene, hung.bodies);
  loaded.files_read.insert(loaded.files_read.end(), hung.bodies.files_read.begin(), hung.bodies.files_read.end());
  DrawnColours colours = drawn_colours(hung.scene, loaded);
  return std::make_shared<const LoadedScene>(
      LoadedScene{std::move(loaded), std::move(hung), std::move(colours), generation});
}

bool keeps_apart(const sim::SimulationSettings& settings) {
  const auto* bounded = std::get_if<sim::BoundedSettings>(&settings.solver.method);
  return bounded != nullptr && bounded->contact;
}

std::string describe_now(const UntangleReport& u) {
  return fmt::format("{} crossed: {}", count_text(u.pairs_before, "pair of triangles", "pairs of triangles"),
                     u.pairs_left == 0
                         ? fmt::format("parted, no vertex was moved by more than {:.3g} mm", 1e3 * u.max_move_m)
                         : fmt::format("{} left, around which contact is off until they are apart", u.pairs_left));
}

}  // namespace

bool has_stopped(const Snapshot& snapshot) {
  return snapshot.stopped && (!snapshot.compared || snapshot.compared->stopped);
}

bool moves(const Snapshot& snapshot) {
  return (!snapshot.stopped && !snapshot.record.asleep) || (snapshot.compared && moves(*snapshot.compared));
}

sim::Simulation continue_from(const Snapshot& past, const sim::SimulationSettings& settings,
                              const sim::Material& material, const sim::Surroundings& surroundings) {
  sim::Simulation simulation(past.garment, *past.pins, past.settings, past.surroundings);
  simulation.restore(*past.checkpoint);
  simulation.set_settings(settings);
  if (material != past.garment->material) simulation.set_material(material);
  simulation.set_surroundings(surroundings);
  return simulation;
}

int first_frame_in_reach(const Snapshot& newest) { return std::max(0, newest.record.frame - reach_frames(newest)); }

void Timeline::add(SnapshotPtr snapshot) {
  kept_.push_back(std::move(snapshot));
  if (++added_ >= drop_interval) {
    added_ = 0;
    drop_old_snapshots();
  }
}

// Drops older snapshots, except the past of the oldest one within the slack.
void Timeline::drop_old_snapshots() {
  if (kept_.size() <= max_window_delay) return;
  const auto young = kept_.end() - max_window_delay;
  const int first = first_frame_in_reach(**young) - max_window_delay;
  std::deque<SnapshotPtr> useful(young, kept_.end());
  SnapshotPtr past = *young;
  for (auto older = std::make_reverse_iterator(young); older != kept_.rend(); ++older) {
    if (!led_to(**older, *past)) continue;
    past = *older;
    if (past->record.frame >= first) useful.push_front(past);
  }
  kept_ = std::move(useful);
}

const SnapshotPtr& Timeline::with_serial(std::uint64_t serial) const {
  const auto found = std::ranges::lower_bound(kept_, serial, {}, &Snapshot::serial);
  return found == kept_.end() ? kept_.back() : *found;
}

SnapshotPtr Timeline::of_frame(const SnapshotPtr& now, int frame) const {
  SnapshotPtr nearest_snapshot = now;
  const auto end = std::ranges::upper_bound(kept_, now->serial, {}, &Snapshot::serial);
  for (auto older = std::make_reverse_iterator(end); older != kept_.rend() && nearest_snapshot->record.frame > frame;
       ++older) {
    if (led_to(**older, *nearest_snapshot)) nearest_snapshot = *older;
  }
  return nearest_snapshot;
}

Grip take_grip(const sim::Garment& garment, std::span<const sim::Vec3> positions, sim::Index vertex) {
  const double reach = reach_around(garment, vertex);
  Grip grip;
  grip.target_m = positions[vertex];
  std::vector<sim::Index> grip_vertices = {vertex};
  std::vector<bool> seen(positions.size(), false);
  seen[vertex] = true;
  double total = 0.0;
  for (std::size_t i = 0; i < grip_vertices.size(); ++i) {
    const sim::Index at = grip_vertices[i];
    const double distance_m = glm::distance(garment.mesh.positions[at], garment.mesh.positions[vertex]);
    const double weight = garment.masses_kg[at] * (1.0 - distance_m / reach);
    grip.vertices.push_back({at, weight, positions[at] - positions[vertex]});
    total += weight;
    for (const sim::Index e : garment.adjacency.vertex_edges[at]) {
      const sim::Index next = sim::other_end(garment.adjacency.edges[e], at);
      if (!seen[next] && glm::distance(garment.mesh.positions[next], garment.mesh.positions[vertex]) < reach) {
        seen[next] = true;
        grip_vertices.push_back(next);
      }
    }
  }
  for (GripVertex& held : grip.vertices) held.share = total > 0.0 ? held.share / total : 0.0;
  return grip;
}

std::vector<sim::GrabbedVertex> held_vertices(const Grip& grip, const sim::Vec3& hand_m, const sim::Garment& garment) {
  const double mass_kg = std::accumulate(garment.masses_kg.begin(), garment.masses_kg.end(), 0.0);
  const double stiffness_n_per_m = mass_kg * swing_rad_per_s * swing_rad_per_s;
  const double force_n = max_pull_weights * mass_kg * earth_m_per_s2;
  return collect<sim::GrabbedVertex>(grip.vertices, [&](const GripVertex& part) {
    return sim::GrabbedVertex{part.vertex, hand_m + part.offset_m, stiffness_n_per_m * part.share,
                              force_n * part.share};
  });
}

sim::Vec3 moved_hand(const sim::Vec3& hand_m, const sim::Vec3& target_m, double time_s) {
  const sim::Vec3 way = target_m - hand_m;
  const double length_m = glm::length(way);
  const double reachable_m = arm_speed_m_per_s * time_s;
  return length_m <= reachable_m ? target_m : hand_m + way * (reachable_m / length_m);
}

LiveSimulation::LiveSimulation(const SceneWithBodies& scene) {
  start(load(scene, 1));
  tell_of_start();
}

LiveSimulation::LiveSimulation(std::shared_ptr<const LoadedScene> loaded) : restart_hint_("R starts both again") {
  start(std::move(loaded));
}

// Does everything that can fail first, so that a scene that cannot be simulated changes nothing.
void LiveSimulation::start(std::shared_ptr<const LoadedScene> loaded) {
  const DrawnScene& scene = loaded->scene;
  sim::Simulation simulation = make_simulation(scene, *loaded, loaded->bodies.all);
  start_frame_ = frame_ = go_to_start(scene, loaded->bodies, simulation);
  now_.record = measure_frame(simulation, frame_);
  simulation_.emplace(std::move(simulation));
  now_.loaded = std::move(loaded);
  surroundings_ = simulation_->surroundings();
  now_.pins = std::make_shared<const std::vector<sim::Index>>(now_.loaded->pins);
  note_shape();
  grip_.reset();
  steps_left_ = 0;
  now_.stopped = false;
  now_.pristine = true;
}

void LiveSimulation::note_shape() { now_.checkpoint = std::make_shared<const sim::Checkpoint>(simulation_->save()); }

void LiveSimulation::apply(const SimulationCommand& command) {
  try {
    std::visit([this](const auto& asked) { perform(asked); }, command);
  } catch (const std::exception& error) {
    tell(error.what(), true);
  }
  if (!now_.stopped) {
    note_shape();  // A command that failed may have done part of its work; most commands wake sleeping cloth.
  }
}

void LiveSimulation::perform(const LoadScene& asked) {
  start(load(*asked.scene, now_.loaded->generation + 1));
  tell("loaded " + asked.scene->scene.name, false);
  tell_of_start();
}

void LiveSimulation::tell_of_start() {
  for (const std::string& remark : now_.loaded->drawn_colours.remarks) tell(remark, false);
  const LoadedScene& loaded = *now_.loaded;
  for (const std::string& remark : remarks_on_start(loaded.scene, loaded, loaded.bodies.all).lines) tell(remark, false);
}

void LiveSimulation::perform(const ChangeSettings& change) {
  if (now_.stopped) {
    start(now_.loaded);  // a stopped simulation cannot continue
  }
  now_.pristine = now_.pristine && frame_ == start_frame_;
  const sim::SimulationSettings settings = simulation_settings(change.simulation);
  if (settings != simulation_->settings() || change.material != simulation_->garment().material) {
    const bool was_kept_apart = keeps_apart(simulation_->settings());
    simulation_->set_settings(settings);
    simulation_->set_material(change.material);
    if (!was_kept_apart && keeps_apart(settings)) untangle(change.simulation);
    // Another bound may move the cloth before the next frame.
    measure_stretches(*simulation_, now_.record);
  }
  surroundings_ = settle_surroundings(change.surroundings, *now_.loaded, now_.loaded->bodies.all);
  simulation_->set_surroundings(surroundings_);
}

// Separates triangles that crossed while contact was off.
void LiveSimulation::untangle(const RunSettings& simulation) {
  sim::Checkpoint now = simulation_->save();
  Scene scene = now_.loaded->scene;
  scene.simulation = simulation;
  std::vector<sim::Vec3> positions_m = now.state.current;
  const std::optional<UntangleReport> untangling =
      untangle_start(scene, simulation_->garment(), false, positions_m, [](const std::string&) {});
  if (!untangling) return;
  for (std::size_t v = 0; v < positions_m.size(); ++v) now.state.previous[v] += positions_m[v] - now.state.current[v];
  now.state.current = now.before_m = positions_m;
  simulation_->restore(now);
  tell(describe_now(*untangling), untangling->pairs_left > 0);
}

void LiveSimulation::perform(const TogglePin& toggle) {
  if (toggle.vertex >= now_.loaded->garment->mesh.positions.size()) {
    return;  // selected on a garment that has been replaced since
  }
  std::vector<sim::Index> pins = *now_.pins;
  const auto place = std::ranges::lower_bound(pins, toggle.vertex);
  if (place != pins.end() && *place == toggle.vertex) {
    pins.erase(place);
  } else {
    pins.insert(place, toggle.vertex);
  }
  simulation_->set_pins(pins);
  now_.pins = std::make_shared<const std::vector<sim::Index>>(std::move(pins));
  now_.pristine = now_.pristine && frame_ == start_frame_;
}

void LiveSimulation::perform(const TakeHold& hold) {
  for (const GripVertex& held : hold.grip.vertices) {
    if (held.vertex >= now_.loaded->garment->mesh.positions.size()) {
      return;  // selected on a garment that has been replaced since
    }
  }
  if (!grip_ && !hold.grip.vertices.empty()) hand_m_ = simulation_->state().current[hold.grip.vertices.front().vertex];
  grip_ = hold.grip;
}

void LiveSimulation::perform(const LetGo&) {
  grip_.reset();
  simulation_->set_surroundings(surroundings_);
}

void LiveSimulation::perform(const Reset&) {
  const sim::SimulationSettings settings = simulation_->settings();
  const sim::Surroundings surroundings = surroundings_;
  const sim::Material material = simulation_->garment().material;
  start(now_.loaded);
  simulation_->set_settings(settings);
  simulation_->set_material(material);
  surroundings_ = surroundings;
  simulation_->set_surroundings(surroundings);
}

void LiveSimulation::perform(const GoBack& back) {
  const Snapshot& past = *back.to;
  if (past.loaded->generation != now_.loaded->generation) {
    return;  // snapshot of a garment that has been replaced since
  }
  grip_.reset();
  simulation_.emplace(continue_from(past, simulation_->settings(), simulation_->garment().material, surroundings_));
  now_.pins = past.pins;
  now_.record = past.record;
  frame_ = past.record.frame;
  measure_stretches(*simulation_, now_.record);
  steps_left_ = 0;
  now_.stopped = false;
  now_.pristine = frame_ == start_frame_;
}

void LiveSimulation::perform(const SetPaused& pause) {
  now_.paused = pause.paused;
  steps_left_ = 0;
}

void LiveSimulation::pull() {
  sim::Surroundings pulled = surroundings_;
  hand_m_ = moved_hand(hand_m_, grip_->target_m, frame_time_s());
  pulled.forces.grabbed_vertices = held_vertices(*grip_, hand_m_, simulation_->garment());
  simulation_->set_surroundings(pulled);
  now_.pristine = false;
}

void LiveSimulation::advance(const std::function<void()>& poll) {
  ++now_.advances;
  steps_left_ = std::max(0, steps_left_ - 1);
  if (now_.stopped) return;
  try {
    if (grip_) pull();
    Stopwatch simulating;
    simulation_->advance_frame(poll);
    const double sim_ms = simulating.elapsed_ms();
    now_.record = measure_frame(*simulation_, ++frame_);
    now_.record.sim_ms = sim_ms;
    note_shape();
    if (now_.loaded->following && std::has_single_bit(static_cast<unsigned>(frame_))) show_simulated_if_torn();
  } catch (const Interrupted&) {
    throw;
  } catch (const sim::ContactBlocked& blocked) {
    stop("frame " + std::to_string(frame_ + 1) + ": " + blocked.what());
  } catch (const std::exception& error) {
    stop(error.what());
  }
}

void LiveSimulation::show_simulated_if_torn() {
  try {
    const std::vector<sim::Vec3> shown_m = now_.loaded->shown_m(simulation_->state().current);
    require_fit_to_show(now_.loaded->following->shape_limits->measure_stretch(shown_m));
  } catch (const ModelOverstretched& error) {
    tell(describe_simulated_shown(error.what()), true);
    LoadedScene shown = *now_.loaded;
    show_simulated(shown);
    shown.drawn_colours = drawn_colours(shown.scene, shown);
    now_.loaded = std::make_shared<const LoadedScene>(std::move(shown));
  }
}

void LiveSimulation::stop(const std::string& reason) {
  now_.stopped = true;
  tell(reason + "; " + restart_hint_, true);
}

SnapshotPtr LiveSimulation::take_snapshot(SnapshotPtr compared) {
  ++now_.serial;
  now_.garment = simulation_->shared_garment();
  now_.settings = simulation_->settings();
  now_.surroundings = simulation_->surroundings();
  now_.compared = std::move(compared);
  return std::make_shared<const Snapshot>(now_);
}

void LiveSimulation::tell(const std::string& text, bool is_error) {
  constexpr std::size_t max_messages_kept = 8;
  std::vector<Notice> notices = *now_.notices;
  notices.push_back({text, is_error, notices.empty() ? 1 : notices.back().number + 1});
  if (notices.size() > max_messages_kept) notices.erase(notices.begin());
  now_.notices = std::make_shared<const std::vector<Notice>>(std::move(notices));
}

}  // namespace taut::app
