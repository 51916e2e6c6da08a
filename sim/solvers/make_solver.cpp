#include "sim/solvers/make_solver.hpp"

#include "sim/solvers/bounded/bounded.hpp"

namespace taut::sim {
namespace {

/// Time steps in a frame, where nothing else asks for more. Fewer let sheets of some hundred vertices
/// stretch.
constexpr int enough_for_small_sheets = 20;

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

/// Hooke's springs need steps that are short enough for their stiffness.
int least_substeps(const SolverSettings& settings, const Frame& frame) {
  const std::optional<SpringStiffness> springs = hooke_springs(settings.method);
  if (settings.substeps || !springs) return 0;
  const double needed = frame.duration_s / stable_time_step_s(frame.garment, frame.pins, *springs,
                                                              frame.surroundings.forces.air_drag_per_s);
  return static_cast<int>(std::ceil(std::min<double>(needed, settings.max_substeps)));
}

/// Divides a frame into equal time steps.
class SteppedSolver : public Solver {
 public:
  SteppedSolver(const SolverSettings& settings, std::unique_ptr<SpringResponse> springs)
      : settings_(settings), springs_(std::move(springs)) {}

  FrameReport advance_frame(const Frame& frame, State& state) override {
    forces_n_.assign(state.current.size(), Vec3(0.0));
    FrameReport report;
    report.substeps = std::max(equal_substeps(settings_), least_substeps(settings_, frame));
    for (int substep = 0; substep < report.substeps; ++substep) {
      frame.ask();
      step(frame.garment, frame.pins, frame.surroundings, *springs_, frame.duration_s / report.substeps, state,
           forces_n_);
    }
    return report;
  }

  // All that it knows is in the state.
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

std::unique_ptr<Solver> solver_of(const SolverSettings& settings, const FastProjectionSettings& projection) {
  require_max_stretch(projection.max_strain);
  if (projection.most_projections < 1) {
    throw std::invalid_argument("fast projection needs at least 1 projection");
  }
  return std::make_unique<FastProjectionSolver>(projection, settings.substeps);
}

std::unique_ptr<Solver> solver_of(const SolverSettings& settings, const ImplicitSettings& implicit) {
  if (!(implicit.stretch_n_per_m >= 0.0 && implicit.shear_n_per_m >= 0.0 && implicit.damping_s >= 0.0 &&
        implicit.tolerance > 0.0 && implicit.largest_stretch_change > 0.0)) {
    throw std::invalid_argument(
        "the stiffness and the damping of implicit steps must be at least 0, their tolerance and their "
        "largest change of stretch above 0");
  }
  return std::make_unique<ImplicitSolver>(implicit, settings.substeps, settings.max_substeps);
}

std::unique_ptr<Solver> solver_of(const SolverSettings& settings, const BoundedSettings& bounded) {
  if (bounded.threads && (*bounded.threads < 1 || *bounded.threads > most_threads)) {
    throw std::invalid_argument("a solver takes 1 to " + std::to_string(most_threads) +
                                " threads, or chooses their number itself");
  }
  require_max_stretch(bounded.max_stretch);
  return std::make_unique<BoundedSolver>(bounded, settings.substeps, settings.max_substeps);
}

template <class Settings> std::unique_ptr<Solver> solver_of(const SolverSettings& settings, const Settings& springs) {
  return std::make_unique<SteppedSolver>(settings, spring_response(springs));
}

}  // namespace

const char* name_of(SolverKind kind) {
  constexpr std::array names = {"ideal", "provot", "strong", "bounded", "vassilev", "fast-projection", "implicit"};
  return names[static_cast<std::size_t>(kind)];
}

SolverKind kind_of(const SolverMethod& method) { return static_cast<SolverKind>(method.index()); }

int equal_substeps(const SolverSettings& settings) { return settings.substeps.value_or(enough_for_small_sheets); }

std::unique_ptr<Solver> make_solver(const SolverSettings& settings) {
  if (settings.substeps.value_or(1) < 1 || settings.max_substeps < 1) {
    throw std::invalid_argument("a solver needs at least 1 substep, or chooses their number itself");
  }
  return std::visit([&](const auto& method) { return solver_of(settings, method); }, settings.method);
}

}  // namespace taut::sim
