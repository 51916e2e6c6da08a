#pragma once

#include "app/base/job_runner.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "sim/solvers/make_solver.hpp"

namespace taut::app {

/// The tests of figure 8, one of each method: hanging, without contact, in frames of 1/60 s unless a test
/// says otherwise.
enum class MethodTest {
  time,    ///< frames of all meshes in turn, with their processor time
  energy,  ///< the coarse shirt is let go where no air slows it down
  rest,    ///< the coarse shirt after its pins were shaken for `shaken_s`
  steps,   ///< the coarse shirt with time steps 1, 2 and 5 times as long as the method's own
};
inline constexpr std::array all_method_tests = {MethodTest::time, MethodTest::energy, MethodTest::rest,
                                                MethodTest::steps};
/// The name used in tables.
const char* name_of(MethodTest test);

/// One frame of a trial, measured from its positions.
struct TrialFrame {
  double time_s = 0.0;
  double frame_ms = 0.0;         ///< processor time of the thread; NaN where it was not measured
  double stretch = 0.0;          ///< of the most stretched structural spring, a fraction
  double surface_stretch = 0.0;  ///< of the most stretched triangle, a fraction
  double energy_j = 0.0;         ///< of motion and of gravity, without what springs store; 0 at the start
  double speed_m_per_s = 0.0;    ///< root mean square over the vertices
  double sunk_m = 0.0;           ///< how far the centre of mass is below where it began
};

/// A method on a mesh.
struct MethodTrial {
  MethodTest test = MethodTest::time;
  sim::SolverKind kind = sim::SolverKind::bounded;
  int triangles = 0;
  int step_factor = 1;   ///< multiplies the length of a frame, where the number of its time steps stays
  int substeps = 0;      ///< the most time steps in a frame
  bool is_lost = false;  ///< it diverged in the frame after the last one
  std::vector<TrialFrame> frames = {};

  /// The largest of all frames, a fraction; infinite if it is lost or has no frame.
  double largest_stretch() const;
  double largest_surface_stretch() const;
  /// Of all frames, in ms, the place `fraction` (0 to 1) of them in ascending order. There must be a frame.
  double ranked_ms(double fraction) const;
  /// Root mean square over the last half second; infinite if it is lost or has no frame.
  double last_speed_m_per_s() const;
};

/// The trials of one test, for each mesh or factor all methods in the order of `trial_methods`.
using MethodTrials = std::vector<MethodTrial>;

/// In the order of their years, the paper's and this program's own last.
inline constexpr std::array trial_methods = {sim::SolverKind::ideal,           sim::SolverKind::provot,
                                             sim::SolverKind::implicit,        sim::SolverKind::vassilev,
                                             sim::SolverKind::fast_projection, sim::SolverKind::strong,
                                             sim::SolverKind::bounded};

/// Triangles of the 9x9 cloth, and those of the coarse shirt.
inline constexpr int trial_grid_triangles = 128, trial_shirt_triangles = 1028;
/// The meshes of the test of time.
inline constexpr std::array trial_meshes = {trial_grid_triangles, trial_shirt_triangles, 5280, 10600};
inline constexpr std::array trial_step_factors = {1, 2, 5};
/// Of all methods that ask for a threshold, a strain or a bound, a fraction.
inline constexpr double trial_max_stretch = 0.01;
/// How long pins swing to and fro, by how much and how often.
inline constexpr double shaken_s = 1.0, shaken_by_m = 0.03, shaken_hz = 3.0;

/// How long trials are.
struct TrialLengths {
  int timed_frames = 12;
  double energy_s = 2.0;
  double shaking_s = shaken_s;  ///< of half swings, after which pins are where they began
  double rest_s = 3.0;          ///< after the shaking
  double steps_s = 1.0;
};

/// Makes the trials of one test. Those of time take turns of a few frames, so that other load on the machine
/// meets all methods alike; nothing else of the program should run meanwhile. `meshes` are theirs alone.
MethodTrials make_trials(MethodTest test, const ProgressCallback& report_progress,
                         const TrialLengths& lengths = {}, std::span<const int> meshes = trial_meshes);

/// The trial of this method among others, with this factor or mesh. Throws std::out_of_range without one.
const MethodTrial& trial_of(const MethodTrials& trials, sim::SolverKind kind,
                            int triangles = trial_shirt_triangles, int step_factor = 1);

}  // namespace taut::app
