#include "sim/simulation.hpp"

#include <string>
#include <utility>

#include "sim/solvers/bounded/within_bound.hpp"

namespace taut::sim {
namespace {

void require_frame_rate(const SimulationSettings& settings) {
  if (!(settings.frame_rate_hz > 0.0)) {
    throw std::invalid_argument("the frame rate must be above 0 Hz");
  }
}

void require_distances(const Surroundings& surroundings) {
  if (!(surroundings.layer_distance_m >= 0.0 && surroundings.cloth_thickness_m >= 0.0)) {
    throw std::invalid_argument("the distance of layers and the thickness of cloth must be at least 0 m");
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
      before_m_(state_.current),
      solver_(make_solver(settings.solver)) {
  require_frame_rate(settings);
  require_distances(surroundings_);
}

void Simulation::advance_frame() {
  before_m_ = state_.current;
  if (state_.asleep) {
    state_.time_s += frame_time_s();
    return;
  }
  report_ = solver_->advance_frame(garment_, surroundings_, frame_time_s(), state_);
  const std::size_t lost = first_lost(state_.current);
  if (lost < state_.current.size()) {
    throw Diverged(static_cast<Index>(lost), state_.time_s);
  }
  fall_asleep_at_rest();
}

void Simulation::start_solver() {
  solver_ = make_solver(settings_.solver);
  move_within_bound(garment_, settings_.solver, state_);
  wake();
}

void Simulation::go_back_to(const State& state) {
  const std::size_t count = garment_.mesh.positions.size();
  if (state.current.size() != count || state.previous.size() != count) {
    throw std::invalid_argument("a state of another garment cannot be gone back to");
  }
  state_ = state;
  state_.predicted.resize(count);
  start_solver();
  before_m_ = state_.current;
}

void Simulation::set_surroundings(const Surroundings& surroundings) {
  if (surroundings != surroundings_) {
    require_distances(surroundings);
    surroundings_ = surroundings;
    wake();
  }
}

void Simulation::set_settings(const SimulationSettings& settings) {
  if (settings != settings_) {
    require_frame_rate(settings);
    make_solver(settings.solver);  // refuses what is wrong before anything has changed
    settings_ = settings;
    start_solver();
  }
}

void Simulation::set_pins(std::vector<Index> pins) {
  hold_by(garment_, std::move(pins));
  wake();
}

void Simulation::wake() {
  state_.asleep = false;
  state_.quiet_frames = 0;
}

void Simulation::fall_asleep_at_rest() {
  const RestSettings& rest = settings_.rest;
  if (!is_steady(surroundings_)) {
    state_.quiet_frames = 0;
    return;
  }
  if (state_.quiet_frames == 0) {
    quiet_since_m_ = before_m_;
  }
  ++state_.quiet_frames;
  const ShapeChange drift = {quiet_since_m_, state_.current, rest.frames * frame_time_s()};
  if (!(rms_speed(drift) < rest.speed_m_per_s)) {
    state_.quiet_frames = 0;
  } else if (state_.quiet_frames >= rest.frames) {
    state_.asleep = true;
    state_.previous = state_.current;
  }
}

}  // namespace taut::sim
