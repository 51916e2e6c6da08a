#include "app/viewer/simulation/simulation_pair.hpp"

#include <utility>

namespace taut::app {

SimulationPair::SimulationPair(const DrawnScene& scene) : first_(scene), settings_(first_.loaded()->scene) {}

void SimulationPair::apply(const SimulationCommand& command) {
  if (const auto* asked = std::get_if<Compare>(&command)) {
    return compare(*asked);
  }
  const std::shared_ptr<const LoadedScene> before = first_.loaded();
  const bool was_stopped = first_.is_stopped();
  const auto* change = std::get_if<ChangeSettings>(&command);
  first_.apply(command);
  if (change != nullptr) {
    settings_ = *change;
  } else if (const auto* pause = std::get_if<SetPaused>(&command)) {
    paused_ = pause->paused;
  } else if (first_.loaded() != before) {
    settings_ = ChangeSettings(first_.loaded()->scene);
  }
  const bool restarts = std::holds_alternative<Reset>(command) || (change != nullptr && was_stopped);
  if (restarts || first_.loaded() != before) {
    begin_second();
  } else if (second_) {
    pass_on(command);
  }
}

void SimulationPair::compare(const Compare& asked) {
  kind_ = asked.with;
  if (kind_) {
    first_.apply(Reset{});
  }
  begin_second();
  if (second_) {
    first_.tell(std::string("compared with ") + sim::name_of(*kind_) + ": both begin anew", false);
  }
}

ChangeSettings SimulationPair::own_settings() const {
  ChangeSettings own = settings_;
  SolverChoice& solver = own.simulation.solver;
  solver = with_solver(solver, *kind_, first_.loaded()->scene.simulation.solver);
  return own;
}

void SimulationPair::begin_second() {
  second_.reset();
  told_notice_ = 0;
  if (!kind_) {
    return;
  }
  try {
    LoadedScene own = *first_.loaded();
    own.scene.simulation = own_settings().simulation;
    second_.emplace(std::make_shared<const LoadedScene>(std::move(own)));
    second_->apply(own_settings());
    second_->apply(SetPaused{paused_});
    pass_on_notices();
  } catch (const std::exception& error) {
    first_.tell(std::string(sim::name_of(*kind_)) + ": " + error.what(), true);
  }
}

void SimulationPair::pass_on(const SimulationCommand& command) {
  if (std::holds_alternative<ChangeSettings>(command)) {
    // A simulation that has stopped would begin anew, and the first one goes on.
    if (!second_->is_stopped()) {
      second_->apply(own_settings());
    }
  } else if (const auto* back = std::get_if<GoBack>(&command)) {
    // A simulation that had stopped by then is as it was.
    if (back->to->compared && !back->to->compared->stopped) {
      second_->apply(GoBack{back->to->compared});
    }
  } else {
    second_->apply(command);
  }
  pass_on_notices();
}

void SimulationPair::pass_on_notices() {
  for (const Notice& notice : second_->notices()) {
    if (notice.number > told_notice_) {
      told_notice_ = notice.number;
      first_.tell(std::string(sim::name_of(*kind_)) + ": " + notice.text, notice.is_error);
    }
  }
}

void SimulationPair::advance(const std::function<void()>& poll) {
  first_.advance(poll);
  if (second_) {
    second_->advance(poll);
    pass_on_notices();
  }
}

SnapshotPtr SimulationPair::take_snapshot() {
  return first_.take_snapshot(second_ ? second_->take_snapshot() : nullptr);
}

}  // namespace taut::app
