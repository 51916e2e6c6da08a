#include "app/viewer/simulation/stepped_simulation.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "app/base/errors.hpp"
#include "app/base/interruption.hpp"

namespace taut::app {
namespace {

// Where a frame of the window took longer, simulated time is given up instead of caught up with.
constexpr double most_owed_s = 0.1;
// A frame of the window and one of the simulation are both 1/60 s: rounding must not skip one.
constexpr double rounding_s = 1e-9;

}  // namespace

SteppedSimulation::SteppedSimulation(const DrawnScene& scene) : simulation_(scene) {
  timeline_.add(simulation_.take_snapshot());
}

void SteppedSimulation::advance() {
  simulation_.advance(throw_if_interrupted);
  timeline_.add(simulation_.take_snapshot());
}

void SteppedSimulation::follow_clock(double elapsed_s) {
  owed_s_ = std::min(owed_s_ + elapsed_s * simulation_.speed(), most_owed_s);
  while (simulation_.wants_to_advance() && owed_s_ + rounding_s >= simulation_.frame_time_s()) {
    owed_s_ -= simulation_.frame_time_s();
    advance();
  }
  if (!simulation_.wants_to_advance()) {
    owed_s_ = 0.0;
  }
}

SnapshotPtr SteppedSimulation::begin_frame(double elapsed_s, const std::optional<Pace>& pace) {
  if (!pace) {
    follow_clock(elapsed_s);
    return timeline_.newest();
  }
  constexpr std::uint64_t most_at_once = 100000;
  if (pace->advances < simulation_.advances() || pace->advances > simulation_.advances() + most_at_once) {
    throw InputError(fmt::format("the session says {} simulated frames after {} of them", pace->advances,
                                 simulation_.advances()));
  }
  while (simulation_.advances() < pace->advances) {
    advance();
  }
  return timeline_.with_serial(pace->shown);
}

std::uint64_t SteppedSimulation::post(std::vector<SimulationCommand> commands) {
  for (const SimulationCommand& command : commands) {
    simulation_.apply(command);
  }
  if (!commands.empty()) {
    timeline_.add(simulation_.take_snapshot());
  }
  return simulation_.advances();
}

}  // namespace taut::app
