#pragma once

#include "sim/solvers/bounded/settings.hpp"
#include "sim/solvers/fast_projection/fast_projection.hpp"
#include "sim/solvers/implicit/implicit.hpp"

namespace taut::sim {

enum class SolverKind { ideal, provot, strong, bounded, vassilev, fast_projection, implicit };

inline constexpr std::array all_solver_kinds = {SolverKind::ideal,   SolverKind::provot,   SolverKind::strong,
                                                SolverKind::bounded, SolverKind::vassilev, SolverKind::fast_projection,
                                                SolverKind::implicit};

const char* name_of(SolverKind kind);

/// The settings of one solver. The alternatives are in the order of SolverKind.
using SolverMethod = std::variant<IdealSettings, ProvotSettings, StrongSettings, BoundedSettings, VassilevSettings,
                                  FastProjectionSettings, ImplicitSettings>;

struct SolverSettings {
  /// Time steps in a frame; none leaves the choice to the solver. More steps stretch less and cost in
  /// proportion; stretch falls about with their square, far better than iterations do (Macklin and others
  /// 2019).
  std::optional<int> substeps = {};
  /// No frame is divided into more time steps than this by a solver that may choose, even if its bound cannot
  /// be kept or its springs are too stiff for them.
  int max_substeps = 2000;
  SolverMethod method = BoundedSettings{};

  bool operator==(const SolverSettings&) const = default;
};

SolverKind kind_of(const SolverMethod& method);

/// The time steps in a frame of the solvers that divide all frames alike: those asked for, or 20. Solvers
/// with Hooke's springs that may choose take more where these would swing up, see stable_time_step_s.
int equal_substeps(const SolverSettings& settings);

/// Throws std::invalid_argument on fewer than one substep or iteration, a number of threads that is out of
/// range, a largest stretch below 0, settings of `implicit` that are
/// out of range or a vector unit this processor lacks.
std::unique_ptr<Solver> make_solver(const SolverSettings& settings);

}  // namespace taut::sim
