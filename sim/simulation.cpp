#include "sim/simulation.hpp"

#include <string>
#include <utility>

#include "sim/measures.hpp"
#include "sim/within_bound.hpp"

namespace taut::sim {
namespace {

void require_frame_rate(const SimulationSettings& settings) {
  if (!(settings.frame_rate_hz > 0.0)) {
    throw std::invalid_argument("the frame rate must be above 0 Hz");
  }
}

}  // namespace

Diverged::Diverged(Index vertex, double time_s)
    : std::runtime_error("the simulation diverged: at " + std::to_string(time_s) + " s vertex " +
                         std::to_string(vertex) +
                         " is lost, its position not finite or beyond all bounds; use more substeps, weaker "
                         "springs or weaker forces") {}

Simulation::Simulation(Garment garment, const SimulationSettings& settings, Surroundings surroundings)
    : garment_(std::move(garment)),
      settings_(settings),
      surroundings_(std::move(surroundings)),
      state_(make_state(garment_)),
      solver_(make_solver(settings.solver)) {
  require_frame_rate(settings);
}

void Simulation::advance_frame() {
  if (state_.asleep) {
    state_.time_s += frame_time_s();
    return;
  }
  report_ = solver_->advance_frame(garment_, surroundings_, frame_time_s(), state_);
  shown_before_m_.clear();
  const std::size_t lost = first_lost(state_.current);
  if (lost < state_.current.size()) {
    throw Diverged(static_cast<Index>(lost), state_.time_s);
  }
  fall_asleep_at_rest();
}

std::span<const Vec3> Simulation::shown_positions() const {
  if (!shown_before_m_.empty()) {
    return shown_before_m_;
  }
  const std::span<const Vec3> shown = solver_->shown_positions();
  return shown.size() == state_.current.size() ? shown : std::span<const Vec3>(state_.current);
}

// A new solver has shown nothing yet: what was shown stays, as far as it keeps the new bound.
void Simulation::start_solver(std::span<const Vec3> shown) {
  auto moved = moved_within_bound(garment_, shown, settings_.solver);
  std::vector<Vec3> kept = moved ? std::move(*moved) : std::vector<Vec3>(shown.begin(), shown.end());
  solver_ = make_solver(settings_.solver);
  shown_before_m_ = std::move(kept);
  wake();
}

void Simulation::go_back_to(const State& state, std::span<const Vec3> shown) {
  const std::size_t count = garment_.mesh.positions.size();
  if (state.current.size() != count || state.previous.size() != count || shown.size() != count) {
    throw std::invalid_argument("a state of another garment cannot be gone back to");
  }
  state_ = state;
  state_.predicted.resize(count);
  start_solver(shown);
}

void Simulation::set_surroundings(const Surroundings& surroundings) {
  if (surroundings != surroundings_) {
    surroundings_ = surroundings;
    wake();
  }
}

void Simulation::set_settings(const SimulationSettings& settings) {
  if (settings != settings_) {
    require_frame_rate(settings);
    make_solver(settings.solver);  // refuses what is wrong before anything has changed
    settings_ = settings;
    start_solver(shown_positions());
  }
}

void Simulation::set_pins(std::vector<Index> pins) {
  garment_ = with_pins(std::move(garment_), std::move(pins));
  wake();
}

void Simulation::wake() {
  state_.asleep = false;
  state_.quiet_frames = 0;
}

void Simulation::fall_asleep_at_rest() {
  const bool quiet = is_steady(surroundings_) && rms_speed(state_) < settings_.rest.speed_m_per_s;
  state_.quiet_frames = quiet ? state_.quiet_frames + 1 : 0;
  if (state_.quiet_frames >= settings_.rest.frames) {
    state_.asleep = true;
    state_.previous = state_.current;
  }
}

}  // namespace taut::sim
