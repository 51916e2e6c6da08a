#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <variant>

#include "sim/bytes.hpp"
#include "sim/garment.hpp"
#include "sim/pins.hpp"
#include "sim/solvers/bounded/settings.hpp"
#include "sim/solvers/ideal.hpp"
#include "sim/solvers/provot.hpp"
#include "sim/solvers/strong.hpp"
#include "sim/state.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {

enum class SolverKind { ideal, provot, strong, bounded };

inline constexpr std::array all_solver_kinds = {SolverKind::ideal, SolverKind::provot, SolverKind::strong,
                                                SolverKind::bounded};

const char* name_of(SolverKind kind);

/// Of one solver; in the order of SolverKind.
using SolverMethod = std::variant<IdealSettings, ProvotSettings, StrongSettings, BoundedSettings>;

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

/// How a frame went.
struct FrameReport {
  int substeps = 0;
  bool bound_promised = false;   ///< by the solver
  bool bound_kept = true;        ///< whether it could keep its promise in this frame
  double raw_max_stretch = 0.0;  ///< before the frame's last correction, which keeps the bound
  /// `bounded`: over the springs that are bound, with those of frames begun again and of the projection.
  double sweeps = 0.0;
  /// `bounded`: about the largest stiffness against compression that time steps of this length answer to:
  /// springs of a fabric that is stiffer push back as if they had this one. Infinite where nothing limits it.
  double followed_compression_n_per_m = std::numeric_limits<double>::infinity();

  bool operator==(const FrameReport&) const = default;
};

/// The time steps in a frame of the solvers that divide all frames alike: those asked for, or 20. `ideal` and
/// `provot` that may choose take more where their springs would swing up, see stable_time_step_s.
int equal_substeps(const SolverSettings& settings);

/// Moves cloth from one frame to the next. How a frame is divided is the solver's own matter.
class Solver {
 public:
  virtual ~Solver() = default;

  /// Advances `state` by one frame.
  virtual FrameReport advance_frame(const Garment& garment, const Pins& pins,
                                    const Surroundings& surroundings, double frame_time_s, State& state) = 0;

  /// What its next frames depend on besides their arguments, as flat data; not what it measured to be quick.
  virtual void save(const Garment& garment, const Pins& pins, ByteWriter& memory) const = 0;

  /// Takes over what a solver of the same settings saved; the arguments are those of its next frame. Throws
  /// BadBytes.
  virtual void restore(const Garment& garment, const Pins& pins, const Surroundings& surroundings,
                       double frame_time_s, ByteReader& memory) = 0;
};

/// Throws std::invalid_argument on fewer than one substep or iteration, a number of threads that is out of
/// range, a largest stretch below 0 or a vector unit this processor lacks.
std::unique_ptr<Solver> make_solver(const SolverSettings& settings);

}  // namespace taut::sim
