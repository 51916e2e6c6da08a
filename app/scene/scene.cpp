#include "app/scene/scene.hpp"

#include "sim/solvers/bounded/promise.hpp"

namespace taut::app {
namespace {

sim::SolverMethod to_method(const SolverChoice& choice) {
  using enum sim::SolverKind;
  const double bound = choice.bounded.max_stretch;
  if (choice.kind == ideal) return choice.ideal;
  if (choice.kind == provot) return sim::ProvotSettings{choice.ideal.stiffness, bound};
  if (choice.kind == strong) return choice.strong;
  if (choice.kind == vassilev) return sim::VassilevSettings{choice.ideal.stiffness, bound};
  if (choice.kind == implicit) return choice.implicit;
  if (choice.kind == fast_projection) {
    return sim::FastProjectionSettings{choice.ideal.stiffness, bound, choice.fast_projection.max_projections};
  }
  return choice.bounded;
}

constexpr sim::PromiseNames promise_keys = {"solver.max_stretch", "gusts (wind.speed, wind.gust_amplitude)",
                                            "solver.allow_exceeding = \"bound\"", "cloth.thickness"};

}  // namespace

sim::SolverSettings solver_settings(const SolverChoice& choice) {
  return {choice.substeps, choice.max_substeps, to_method(choice)};
}

SolverChoice with_solver(SolverChoice choice, sim::SolverKind kind, const SolverChoice& of_scene) {
  if (kind != choice.kind) {
    choice.kind = kind;
    choice.substeps = kind == of_scene.kind ? of_scene.substeps : std::nullopt;
  }
  return choice;
}

std::optional<sim::SolverKind> solver_named(std::string_view name) {
  const auto* const found =
      std::ranges::find(sim::all_solver_kinds, name, [](sim::SolverKind kind) { return sim::to_name(kind); });
  return found == sim::all_solver_kinds.end() ? std::nullopt : std::optional(*found);
}

sim::SimulationSettings simulation_settings(const RunSettings& run) {
  return {run.frame_rate_hz, solver_settings(run.solver), run.rest};
}

std::optional<std::string> unpromised_bound_reason(const Scene& scene) {
  const SolverChoice& solver = scene.simulation.solver;
  return solver.kind == sim::SolverKind::bounded
             ? sim::unpromised_bound_reason(solver.bounded, scene.surroundings, promise_keys)
             : std::nullopt;
}

std::optional<std::string> missing_contact_reason(const Scene& scene, const sim::Garment& garment) {
  const SolverChoice& solver = scene.simulation.solver;
  return solver.kind == sim::SolverKind::bounded ? sim::missing_contact_reason(solver.bounded, garment, promise_keys)
                                                 : std::nullopt;
}

std::optional<double> stretch_bound(const Scene& scene) {
  const SolverChoice& solver = scene.simulation.solver;
  const sim::SolverMethod method = solver_settings(solver).method;
  return std::visit(
      [&](const auto& settings) {
        constexpr bool has_bound = requires { settings.max_stretch; }
        || requires { settings.max_strain; };
        return has_bound ? std::optional(solver.bounded.max_stretch) : std::nullopt;
      },
      method);
}

sim::BoundKind bound_kind(const Scene& scene) {
  const SolverChoice& solver = scene.simulation.solver;
  return solver.kind == sim::SolverKind::bounded ? solver.bounded.bound : sim::BoundKind::springs;
}

const char* bound_word(const Scene& scene) {
  return scene.simulation.solver.kind == sim::SolverKind::bounded ? "bound" : "threshold";
}

}  // namespace taut::app
