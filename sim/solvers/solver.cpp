#include "sim/solvers/solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "sim/solvers/bounded/bounded.hpp"
#include "sim/solvers/provot.hpp"
#include "sim/solvers/stable_step.hpp"
#include "sim/solvers/strong.hpp"
#include "sim/step.hpp"

namespace taut::sim {
namespace {

/// Hooke's springs need steps that are short enough for their stiffness.
int least_substeps(const SolverSettings& settings, const Garment& garment, const ExternalForces& forces,
                   double frame_time_s) {
  const bool is_hooke = settings.kind == SolverKind::ideal || settings.kind == SolverKind::provot;
  if (settings.substeps > 0 || !is_hooke) {
    return 0;
  }
  const double needed = frame_time_s / stable_time_step_s(garment, settings.stiffness, forces.air_drag_per_s);
  return static_cast<int>(std::ceil(std::min<double>(needed, settings.max_substeps)));
}

/// Divides a frame into equal time steps.
class SteppedSolver : public Solver {
 public:
  SteppedSolver(const SolverSettings& settings, std::unique_ptr<SpringResponse> springs)
      : settings_(settings), springs_(std::move(springs)) {}

  FrameReport advance_frame(const Garment& garment, const Surroundings& surroundings, double frame_time_s,
                            State& state) override {
    buffers_.forces_n.assign(state.current.size(), Vec3(0.0));
    FrameReport report;
    report.substeps = std::max(equal_substeps(settings_),
                               least_substeps(settings_, garment, surroundings.forces, frame_time_s));
    for (int substep = 0; substep < report.substeps; ++substep) {
      step(garment, surroundings, *springs_, frame_time_s / report.substeps, state, buffers_);
    }
    return report;
  }

 private:
  SolverSettings settings_;
  std::unique_ptr<SpringResponse> springs_;
  StepBuffers buffers_;
};

std::unique_ptr<SpringResponse> make_spring_response(const SolverSettings& settings) {
  switch (settings.kind) {
    case SolverKind::ideal:
      return std::make_unique<IdealSprings>(settings.stiffness);
    case SolverKind::provot:
      return std::make_unique<ProvotThreshold>(settings.stiffness, settings.max_stretch);
    case SolverKind::strong:
      return std::make_unique<StrongConstraint>(settings.iterations, settings.rigidity);
    case SolverKind::bounded:
      break;
  }
  throw std::invalid_argument("unknown solver");
}

}  // namespace

const char* name_of(SolverKind kind) {
  constexpr std::array names = {"ideal", "provot", "strong", "bounded"};
  return names[static_cast<std::size_t>(kind)];
}

int equal_substeps(const SolverSettings& settings) {
  constexpr int enough_for_small_sheets = 20;
  return settings.substeps > 0 ? settings.substeps : enough_for_small_sheets;
}

std::unique_ptr<Solver> make_solver(const SolverSettings& settings) {
  if (settings.substeps < 0 || settings.max_substeps < 1 || settings.iterations < 1) {
    throw std::invalid_argument(
        "a solver needs at least 1 substep and 1 iteration, or 0 substeps to choose them itself");
  }
  if (settings.threads < 0 || settings.threads > most_threads) {
    throw std::invalid_argument("a solver takes 1 to " + std::to_string(most_threads) +
                                " threads, or 0 to choose their number itself");
  }
  if (!(settings.max_stretch >= 0.0)) {
    throw std::invalid_argument("the largest stretch must be at least 0");
  }
  if (settings.kind == SolverKind::bounded) {
    return std::make_unique<BoundedSolver>(settings);
  }
  return std::make_unique<SteppedSolver>(settings, make_spring_response(settings));
}

}  // namespace taut::sim
