#include "app/scene/promise.hpp"

#include "sim/solvers/bounded/promise.hpp"

namespace taut::app {
namespace {

constexpr sim::PromiseNames keys = {"solver.max_stretch", "gusts (wind.speed, wind.gust_amplitude)",
                                    "solver.allow_exceeding = \"bound\"", "cloth.thickness"};

}  // namespace

std::optional<std::string> beyond_promise(const Scene& scene) {
  const SolverChoice& solver = scene.simulation.solver;
  return solver.kind == sim::SolverKind::bounded
             ? sim::beyond_promise(solver.bounded, scene.surroundings, keys)
             : std::nullopt;
}

std::optional<std::string> beyond_contact(const Scene& scene, const sim::Garment& garment) {
  const SolverChoice& solver = scene.simulation.solver;
  return solver.kind == sim::SolverKind::bounded ? sim::beyond_contact(solver.bounded, garment, keys)
                                                 : std::nullopt;
}

std::optional<double> stretch_bound(const Scene& scene) {
  const SolverChoice& solver = scene.simulation.solver;
  const sim::SolverMethod method = solver_settings(solver).method;
  return std::visit(
      [&](const auto& settings) {
        constexpr bool has_bound = requires {
          settings.max_stretch;
        }
        || requires {
          settings.max_strain;
        };
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
