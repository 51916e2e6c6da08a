#pragma once

#include <optional>
#include <string_view>

#include "sim/simulation.hpp"

namespace taut::app {

/// Settings of all solvers, and which solver is used. All are kept because a scene file may name the solver
/// after its settings.
struct SolverChoice {
  sim::SolverKind kind = sim::SolverKind::bounded;
  std::optional<int> substeps;                            ///< time steps per frame; empty: the solver chooses
  int max_substeps = sim::SolverSettings{}.max_substeps;  ///< the most that a solver may choose
  /// `provot`, `vassilev` and `fast-projection` use these springs too.
  sim::IdealSettings ideal;
  sim::StrongSettings strong;
  /// `provot`, `vassilev` and `fast-projection` use this largest stretch too.
  sim::BoundedSettings bounded;
  sim::FastProjectionSettings fast_projection;  ///< without what is used of the others
  sim::ImplicitSettings implicit;

  bool operator==(const SolverChoice&) const = default;
};

/// The settings of the solver that is used.
sim::SolverSettings solver_settings(const SolverChoice& choice);

/// The same settings for another solver. Time steps that are short enough for one solver may make another fly
/// apart: a number of them stands for the solver that the scene has it for, and any other chooses its own.
SolverChoice with_solver(SolverChoice choice, sim::SolverKind kind, const SolverChoice& of_scene);

/// The solver that has this name; empty if none has.
std::optional<sim::SolverKind> solver_named(std::string_view name);

/// How a scene is simulated.
struct RunSettings {
  double frame_rate_hz = sim::SimulationSettings{}.frame_rate_hz;
  SolverChoice solver;
  sim::RestSettings rest;

  bool operator==(const RunSettings&) const = default;
};

/// The same settings as the simulation takes them.
sim::SimulationSettings simulation_settings(const RunSettings& run);

}  // namespace taut::app
