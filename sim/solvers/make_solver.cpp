#include "sim/solvers/make_solver.hpp"

#include "sim/solvers/bounded/bounded.hpp"

namespace taut::sim {
namespace {

/// Default time steps per frame. With fewer, sheets of some hundred vertices stretch.
constexpr int default_substeps = 20;

std::optional<SpringStiffness> hooke_springs(const SolverMethod& method) {
  return std::visit(
      [](const auto& settings) -> std::optional<SpringStiffness> {
        if constexpr (requires { settings.stiffness; }) {
          return settings.stiffness;
        }
        return std::nullopt;
      },
      method);
}

/// Returns the substeps that the stability of Hooke's springs requires; 0 without such springs or with a given number.
int min_substeps(const SolverSettings& settings, const Frame& frame) {
  const std::optional<SpringStiffness> springs = hooke_springs(settings.method);
  if (settings.substeps || !springs) return 0;
  const double needed = frame.duration_s / stable_time_step_s(frame.garment, frame.pins, *springs,
                                                              frame.surroundings.forces.air_drag_per_s);
  return static_cast<int>(std::ceil(std::min<double>(needed, settings.max_substeps)));
}

/// Solver that divides a frame into equal time steps.
class SteppedSolver : public Solver {
 public:
  SteppedSolver(const SolverSettings& settings, std::unique_ptr<SpringResponse> springs)
      : settings_(settings), springs_(std::move(springs)) {}

  FrameReport advance_frame(const Frame& frame, State& state) override {
    forces_n_.assign(state.current.size(), Vec3(0.0));
    FrameReport report;
    report.substeps = std::max(equal_substeps(settings_), min_substeps(settings_, frame));
    for (int substep = 0; substep < report.substeps; ++substep) {
      frame.ask();
      step(frame.garment, frame.pins, frame.surroundings, frame.wind_fractions, *springs_,
           frame.duration_s / report.substeps, state, forces_n_);
    }
    return report;
  }

  // The solver has no memory besides the state.
  void save(const Garment&, const Pins&, ByteWriter&) const override {}
  void restore(const Frame&, ByteReader&) override {}

 private:
  SolverSettings settings_;
  std::unique_ptr<SpringResponse> springs_;
  std::vector<Vec3> forces_n_;
};

void require_max_stretch(double max_stretch) {
  if (!(max_stretch >= 0.0)) throw std::invalid_argument("the largest stretch must be at least 0");
}

std::unique_ptr<SpringResponse> spring_response(const IdealSettings& settings) {
  return std::make_unique<IdealSprings>(settings);
}

std::unique_ptr<SpringResponse> spring_response(const ProvotSettings& settings) {
  require_max_stretch(settings.max_stretch);
  return std::make_unique<ProvotThreshold>(settings);
}

std::unique_ptr<SpringResponse> spring_response(const VassilevSettings& settings) {
  require_max_stretch(settings.max_stretch);
  return std::make_unique<VelocityModification>(settings);
}

std::unique_ptr<SpringResponse> spring_response(const StrongSettings& settings) {
  if (settings.iterations < 1) {
    throw std::invalid_argument("the strong constraint needs at least 1 iteration");
  }
  return std::make_unique<StrongConstraint>(settings);
}

std::unique_ptr<Solver> make_solver_for(const SolverSettings& settings, const FastProjectionSettings& projection) {
  require_max_stretch(projection.max_strain);
  if (projection.max_projections < 1) {
    throw std::invalid_argument("fast projection needs at least 1 projection");
  }
  return std::make_unique<FastProjectionSolver>(projection, settings.substeps);
}

std::unique_ptr<Solver> make_solver_for(const SolverSettings& settings, const ImplicitSettings& implicit) {
  if (!(implicit.stretch_n_per_m >= 0.0 && implicit.shear_n_per_m >= 0.0 && implicit.damping_s >= 0.0 &&
        implicit.tolerance > 0.0 && implicit.max_stretch_change > 0.0)) {
    throw std::invalid_argument(
        "the stiffness and the damping of implicit steps must be at least 0, their tolerance and their "
        "largest change of stretch above 0");
  }
  return std::make_unique<ImplicitSolver>(implicit, settings.substeps, settings.max_substeps);
}

std::unique_ptr<Solver> make_solver_for(const SolverSettings& settings, const BoundedSettings& bounded) {
  if (bounded.threads && (*bounded.threads < 1 || *bounded.threads > max_threads)) {
    throw std::invalid_argument("a solver takes 1 to " + std::to_string(max_threads) +
                                " threads, or chooses their number itself");
  }
  require_max_stretch(bounded.max_stretch);
  return std::make_unique<BoundedSolver>(bounded, settings.substeps, settings.max_substeps);
}

template <class Settings>
std::unique_ptr<Solver> make_solver_for(const SolverSettings& settings, const Settings& springs) {
  return std::make_unique<SteppedSolver>(settings, spring_response(springs));
}

}  // namespace

const char* to_name(SolverKind kind) {
  constexpr std::array names = {"ideal", "provot", "strong", "bounded", "vassilev", "fast-projection", "implicit"};
  return names[static_cast<std::size_t>(kind)];
}

SolverKind solver_kind(const SolverMethod& method) { return static_cast<SolverKind>(method.index()); }

int equal_substeps(const SolverSettings& settings) { return settings.substeps.value_or(default_substeps); }

std::unique_ptr<Solver> make_solver(const SolverSettings& settings) {
  if (settings.substeps.value_or(1) < 1 || settings.max_substeps < 1) {
    throw std::invalid_argument("a solver needs at least 1 substep, or chooses their number itself");
  }
  return std::visit([&](const auto& method) { return make_solver_for(settings, method); }, settings.method);
}

}  // namespace taut::sim
