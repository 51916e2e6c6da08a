#pragma once

#include <limits>
#include <memory>

#include "sim/garment.hpp"
#include "sim/solvers/bounded/kernels/vector_unit.hpp"
#include "sim/solvers/ideal.hpp"
#include "sim/state.hpp"
#include "sim/strong_constraint.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {

enum class SolverKind { ideal, provot, strong, bounded };

inline constexpr std::array all_solver_kinds = {SolverKind::ideal, SolverKind::provot, SolverKind::strong,
                                                SolverKind::bounded};

const char* name_of(SolverKind kind);

/// `bounded`: the cloth in physical terms, which do not depend on how finely it is meshed.
struct Fabric {
  double bending_rigidity_n_m = 5e-6;  ///< a soft jersey; denim has about ten times that
  /// Of springs shorter than at rest: less crumples sooner. See FrameReport::followed_compression_n_per_m.
  double compression_stiffness_n_per_m = 30.0;

  bool operator==(const Fabric&) const = default;
};

inline constexpr int most_threads = 64;

struct SolverSettings {
  SolverKind kind = SolverKind::bounded;
  /// Time steps in a frame; 0 leaves the choice to the solver. More steps stretch less and cost in
  /// proportion; stretch falls about with their square, far better than iterations do (Macklin and others
  /// 2019).
  int substeps = 0;
  /// `strong`: sweeps of the constraint in every time step.
  int iterations = 4;
  Rigidity rigidity;          ///< `strong`
  SpringStiffness stiffness;  ///< `ideal`, `provot`
  /// `bounded`: no structural or shear spring is longer than this beyond its rest length at the end of a
  /// frame. `provot`: the threshold above which a spring is pulled back.
  double max_stretch = 0.05;
  Fabric fabric;  ///< `bounded`
  /// No frame is divided into more time steps than this by a solver that may choose, even if its bound cannot
  /// be kept or its springs are too stiff for them.
  int max_substeps = 2000;
  /// `bounded`: no vertex gets further from its pin than the way along the cloth is long.
  bool tethers = true;
  VectorUnit vector_unit = VectorUnit::best;  ///< `bounded`; never changes a result
  /// `bounded`: 0 takes one, or for garments above some 20 000 triangles as many as the machine has, up to 4.
  /// Never changes a result.
  int threads = 0;

  bool operator==(const SolverSettings&) const = default;
};

/// How a frame went.
struct FrameReport {
  int substeps = 0;
  bool bound_promised = false;   ///< by the solver
  bool bound_kept = true;        ///< whether it could keep its promise in this frame
  double raw_max_stretch = 0.0;  ///< before the frame's last correction, which keeps the bound
  /// `bounded`: over the springs that are bound, with those of frames begun again and of the certificate.
  double sweeps = 0.0;
  /// `bounded`: about the largest stiffness against compression that time steps of this length answer to:
  /// springs of a fabric that is stiffer push back as if they had this one. Infinite where nothing limits it.
  double followed_compression_n_per_m = std::numeric_limits<double>::infinity();
};

/// The time steps in a frame of the solvers that divide all frames alike: those asked for, or 20. `ideal` and
/// `provot` that may choose take more where their springs would swing up, see stable_time_step_s.
int equal_substeps(const SolverSettings& settings);

/// Moves cloth from one frame to the next. How a frame is divided is the solver's own matter.
class Solver {
 public:
  virtual ~Solver() = default;

  /// Advances `state` by one frame.
  virtual FrameReport advance_frame(const Garment& garment, const Surroundings& surroundings,
                                    double frame_time_s, State& state) = 0;
};

/// Throws std::invalid_argument on a negative count of substeps, fewer than one iteration, a number of
/// threads that is out of range or a largest stretch below 0.
std::unique_ptr<Solver> make_solver(const SolverSettings& settings);

}  // namespace taut::sim
