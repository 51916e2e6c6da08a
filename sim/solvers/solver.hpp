#pragma once

#include <memory>

#include "sim/garment.hpp"
#include "sim/solvers/ideal.hpp"
#include "sim/state.hpp"
#include "sim/strong_constraint.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {

enum class SolverKind { ideal, provot, strong };

inline constexpr std::array all_solver_kinds = {SolverKind::ideal, SolverKind::provot, SolverKind::strong};

const char* name_of(SolverKind kind);

struct SolverSettings {
  SolverKind kind = SolverKind::strong;
  /// Time steps in a frame. More steps stretch less and cost in proportion; stretch falls about with their
  /// square, far better than iterations do (Macklin and others 2019).
  int substeps = 20;
  /// `strong`: sweeps of the constraint in every time step.
  int iterations = 4;
  Rigidity rigidity;          ///< `strong`
  SpringStiffness stiffness;  ///< `ideal`, `provot`
  /// `provot`: the threshold above which a spring is pulled back. 0.1 is Provot's own.
  double max_stretch = 0.1;

  bool operator==(const SolverSettings&) const = default;
};

/// Moves cloth from one frame to the next. How a frame is divided is the solver's own matter.
class Solver {
 public:
  virtual ~Solver() = default;

  /// Advances `state` by one frame.
  virtual void advance_frame(const Garment& garment, const Surroundings& surroundings, double frame_time_s,
                             State& state) = 0;
};

/// Throws std::invalid_argument on fewer than one substep or iteration or a negative largest stretch.
std::unique_ptr<Solver> make_solver(const SolverSettings& settings);

}  // namespace taut::sim
