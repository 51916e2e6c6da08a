#include "app/scene/run_settings.hpp"

#include <algorithm>

namespace taut::app {
namespace {

sim::SolverMethod method_of(const SolverChoice& choice) {
  switch (choice.kind) {
    case sim::SolverKind::ideal:
      return choice.ideal;
    case sim::SolverKind::provot:
      return sim::ProvotSettings{choice.ideal.stiffness, choice.bounded.max_stretch};
    case sim::SolverKind::strong:
      return choice.strong;
    case sim::SolverKind::vassilev:
      return sim::VassilevSettings{choice.ideal.stiffness, choice.bounded.max_stretch};
    case sim::SolverKind::fast_projection:
      return sim::FastProjectionSettings{choice.ideal.stiffness, choice.bounded.max_stretch,
                                         choice.fast_projection.most_projections};
    case sim::SolverKind::implicit:
      return choice.implicit;
    case sim::SolverKind::bounded:
      break;
  }
  return choice.bounded;
}

}  // namespace

sim::SolverSettings solver_settings(const SolverChoice& choice) {
  return {choice.substeps, choice.max_substeps, method_of(choice)};
}

SolverChoice with_solver(SolverChoice choice, sim::SolverKind kind, const SolverChoice& of_scene) {
  if (kind != choice.kind) {
    choice.kind = kind;
    choice.substeps = kind == of_scene.kind ? of_scene.substeps : std::nullopt;
  }
  return choice;
}

std::optional<sim::SolverKind> solver_named(std::string_view name) {
  const auto* const found = std::find_if(sim::all_solver_kinds.begin(), sim::all_solver_kinds.end(),
                                         [&](sim::SolverKind kind) { return name == sim::name_of(kind); });
  return found == sim::all_solver_kinds.end() ? std::nullopt : std::optional(*found);
}

sim::SimulationSettings simulation_settings(const RunSettings& run) {
  return {run.frame_rate_hz, solver_settings(run.solver), run.rest};
}

}  // namespace taut::app
