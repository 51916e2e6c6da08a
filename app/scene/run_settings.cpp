#include "app/scene/run_settings.hpp"

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

sim::SimulationSettings simulation_settings(const RunSettings& run) {
  return {run.frame_rate_hz, solver_settings(run.solver), run.rest};
}

}  // namespace taut::app
