#pragma once

#include "sim/solvers/bounded/settings.hpp"
#include "sim/solvers/fast_projection/fast_projection.hpp"
#include "sim/solvers/implicit/implicit.hpp"

namespace taut::sim {

enum class SolverKind { ideal, provot, strong, bounded, vassilev, fast_projection, implicit };

inline constexpr std::array all_solver_kinds = {SolverKind::ideal,   SolverKind::provot,   SolverKind::strong,
                                                SolverKind::bounded, SolverKind::vassilev, SolverKind::fast_projection,
                                                SolverKind::implicit};

const char* to_name(SolverKind kind);

/// Settings of one solver, in the order of SolverKind.
using SolverMethod = std::variant<IdealSettings, ProvotSettings, StrongSettings, BoundedSettings, VassilevSettings,
                                  FastProjectionSettings, ImplicitSettings>;

struct SolverSettings {
  /// Time steps per frame; chosen by the solver if not set. More steps stretch less and cost in proportion. Stretch
  /// falls about with their square, far better than with iterations (Macklin and others 2019).
  std::optional<int> substeps = {};
  /// Largest number of time steps per frame of a solver that chooses them, even if its bound cannot be kept or its
  /// springs are too stiff.
  int max_substeps = 2000;
  SolverMethod method = BoundedSettings{};

  bool operator==(const SolverSettings&) const = default;
};

SolverKind solver_kind(const SolverMethod& method);

/// Returns the time steps per frame of solvers with equal steps: the number asked for, or 20. With Hooke's springs and
/// no given number, solvers take more where stable_time_step_s requires it.
int equal_substeps(const SolverSettings& settings);

/// Throws std::invalid_argument on fewer than one substep or iteration, a number of threads out of range, a largest
/// stretch below 0, settings of `implicit` out of range or a vector unit this processor lacks.
std::unique_ptr<Solver> make_solver(const SolverSettings& settings);

}  // namespace taut::sim
