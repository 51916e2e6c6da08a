#pragma once

#include "app/figures/figures.hpp"
#include "sim/solvers/make_solver.hpp"
#include "tests/claims/rest_shapes.hpp"
#include "tests/claims/truth.hpp"

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
inline constexpr std::array trial_methods = {
    sim::SolverKind::ideal,           sim::SolverKind::provot, sim::SolverKind::implicit, sim::SolverKind::vassilev,
    sim::SolverKind::fast_projection, sim::SolverKind::strong, sim::SolverKind::bounded};

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

/// Makes the trials of one test. Trials of time take turns of a few frames, so that other load on the machine
/// meets all methods alike; nothing else of the program should run meanwhile. `meshes` are theirs alone.
MethodTrials make_trials(MethodTest test, const ProgressCallback& report_progress, const TrialLengths& lengths = {},
                         std::span<const int> meshes = trial_meshes);

/// The trial of this method among others, with this factor or mesh. Throws std::out_of_range without one.
const MethodTrial& trial_of(const MethodTrials& trials, sim::SolverKind kind, int triangles = trial_shirt_triangles,
                            int step_factor = 1);

/// How a model maps to springs: the number of each.
struct Mapping {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t structural = 0;      ///< springs
  std::size_t flexural = 0;        ///< springs
  std::size_t loose_vertices = 0;  ///< vertices without a spring
};

/// The result of one solver on a garment that starts as it was modelled.
struct TrialRun {
  double largest_stretch = 0.0;  ///< of all frames, a fraction; not finite if the run diverged
  double median_ms = 0.0;        ///< per frame; other experiments ran at the same time
};

/// A model that was read, mapped to springs and simulated.
struct GarmentTrial {
  std::string file;
  std::string kind;     ///< what is special about it
  std::string refusal;  ///< Why it could not be read or mapped. If not empty, the members below are not set.
  Mapping mapping;
  TrialRun strong;   ///< the paper's method, with equation (3) in full
  TrialRun bounded;  ///< with the bound trial_bound
};

/// Frames of each trial.
inline constexpr int trial_frames = 45;
// The solver's own where nothing is said.
inline constexpr int trial_steps = 20;
inline constexpr int trial_sweeps = 4;
/// Bound on stretch for `bounded`, a fraction.
inline constexpr double trial_bound = 0.05;

/// Reads a model file as every command does, hangs it by its top and simulates it with both solvers.
GarmentTrial try_garment(const std::string& file, const std::string& kind, const ProgressCallback& report_progress);

/// Tries the sample garments (assets/garments/samples) and the three shirts.
std::vector<GarmentTrial> try_garments(const ProgressCallback& report_progress);

/// Largest stretch of a run, a fraction. Not finite if the run diverged.
struct StretchNumbers {
  double at_end = 0.0;      ///< of the last frame
  double on_the_way = 0.0;  ///< of all frames
};

/// A run of the paper's method with a number of steps per frame and of sweeps per step.
struct StrongRun {
  std::string garment;
  /// Equation (3) in full. Otherwise springs give way to compression, so that cloth can fold.
  bool is_rigid = false;
  int substeps = 0;  ///< time steps per frame
  int sweeps = 0;    ///< over all springs, per step
  StretchNumbers stretch;
  /// The largest of all frames, each member by itself. Not finite if the run diverged.
  sim::SurfaceStretch surface = {};
};

/// Compares an uninterrupted run with one that was continued from p(t) and p(t - dt) alone.
struct RestartRun {
  std::uint64_t uninterrupted_hash = 0;
  std::uint64_t restarted_hash = 0;
  int steps_before = 0;
  int steps_after = 0;
};

/// Runs the scene for `steps_before` steps and copies its two position arrays into a new state. Then
/// continues both for `steps_after` steps.
RestartRun run_restart(const DrawnScene& scene, int steps_before, int steps_after);

/// Multiples of the stiffness of figure 7. The last one is near the most that the short step allows.
inline constexpr std::array stiffness_factors = {1.0, 2.0, 4.0};

/// How the shortest times grow with the triangles, by two laws. A geometric law multiplies the time by a
/// constant factor for each added triangle. A misfit is the root mean square distance of the logarithms of
/// the times.
struct TimeGrowth {
  double exponent = 0.0;          ///< of the best power law
  double power_misfit = 0.0;      ///< of the best power law
  double geometric_misfit = 0.0;  ///< of the best geometric law
};
/// Fits both laws to the times that were measured with this number of substeps.
TimeGrowth measure_growth(const std::vector<FrameTimes>& times, int substeps);

/// The results that figure 8 and the claims are judged by besides the results of the other figures.
struct ClaimResults : Results {
  std::vector<GarmentTrial> garments;
  /// Ideal springs with the short step, one run for each of stiffness_factors.
  std::vector<MethodRun> ideal_stiffnesses;
  std::vector<StrongRun> strong_runs;
  RestartRun restart;
  std::vector<TruthPoint> truth;
  std::vector<RestComparison> rests;
  std::array<MethodTrials, all_method_tests.size()> trials;  ///< one for each of MethodTest

  MethodTrials& trials_of(MethodTest test) { return trials[static_cast<std::size_t>(test)]; }
  const MethodTrials& trials_of(MethodTest test) const { return trials[static_cast<std::size_t>(test)]; }
};

/// The simulations that figure 8 and the claims need, as experiments() has those of the figures.
std::vector<Job> claim_experiments(ClaimResults& results);

/// The methods that the paper argues with, on the same shirts.
Figure figure8_of(ClaimResults& results);
/// Its table, and reads one. Throws InputError that names the file and the line.
std::string figure8_csv(const ClaimResults& results);
void read_figure8(ClaimResults& results, const std::filesystem::path& folder);

/// Reads the tables of the figure of this name, if it has any, into the results, so that it can be drawn without its
/// experiments. Throws InputError that names the file and the line.
void read_figure(const std::string& name, const std::filesystem::path& folder, ClaimResults& results);

}  // namespace taut::app
