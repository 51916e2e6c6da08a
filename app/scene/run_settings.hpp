#pragma once

#include <optional>

#include "sim/simulation.hpp"

namespace taut::app {

/// What a scene says about solvers: about all of them, as keys come in any order and the one that is chosen
/// may be named last.
struct SolverChoice {
  sim::SolverKind kind = sim::SolverKind::bounded;
  std::optional<int> substeps;  ///< none: the solver chooses
  int max_substeps = sim::SolverSettings{}.max_substeps;
  sim::IdealSettings ideal;  ///< `provot` has the same springs
  sim::StrongSettings strong;
  sim::BoundedSettings bounded;  ///< `provot` has the same largest stretch

  bool operator==(const SolverChoice&) const = default;
};

/// Of the solver that is chosen.
sim::SolverSettings solver_settings(const SolverChoice& choice);

/// How a scene is simulated.
struct RunSettings {
  double frame_rate_hz = sim::SimulationSettings{}.frame_rate_hz;
  SolverChoice solver;
  sim::RestSettings rest;

  bool operator==(const RunSettings&) const = default;
};

sim::SimulationSettings simulation_settings(const RunSettings& run);

}  // namespace taut::app
