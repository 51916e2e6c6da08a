#pragma once

#include "app/figures/figures.hpp"
#include "sim/solvers/make_solver.hpp"
#include "tests/study/claims/truth.hpp"

namespace taut::app {

/// Tests of figure 8, in which each method has a trial: hanging cloth without contact, in frames of 1/60 s unless
/// stated otherwise.
enum class MethodTest {
  time,    ///< frames of all meshes in turn, with their CPU time
  energy,  ///< the coarse shirt is released in a vacuum
  rest,    ///< the coarse shirt after its pins were shaken for `shaken_s`
  steps,   ///< the coarse shirt with time steps 1, 2 and 5 times as long as the method's own
};
inline constexpr std::array all_method_tests = {MethodTest::time, MethodTest::energy, MethodTest::rest,
                                                MethodTest::steps};
/// Returns the name for tables.
const char* to_name(MethodTest test);

/// A frame of a trial, measured from its positions.
struct TrialFrame {
  double time_s = 0.0;
  double frame_ms = 0.0;         ///< CPU time of the thread; NaN if not measured
  double stretch = 0.0;          ///< largest of the structural springs, a fraction
  double surface_stretch = 0.0;  ///< largest of the triangles, a fraction
  double energy_j = 0.0;         ///< kinetic and gravitational energy, without the springs' energy; 0 at the start
  double speed_m_per_s = 0.0;    ///< root mean square over the vertices
  double sunk_m = 0.0;           ///< distance of the centre of mass below its start
};

/// A method on a mesh.
struct MethodTrial {
  MethodTest test = MethodTest::time;
  sim::SolverKind kind = sim::SolverKind::bounded;
  int triangles = 0;
  int step_factor = 1;   ///< multiplies the length of a frame, whose number of time steps stays
  int substeps = 0;      ///< most time steps in a frame
  bool is_lost = false;  ///< diverged in the frame after the last one
  std::vector<TrialFrame> frames = {};

  /// Return the largest value of all frames, a fraction; infinite if the trial is lost or has no frame.
  double max_stretch_seen() const;
  double max_surface_stretch() const;
  /// Returns the frame time in ms at position `fraction` (0 to 1) of the sorted times. There must be a frame.
  double ranked_ms(double fraction) const;
  /// Returns the root mean square over the last half second; infinite if the trial is lost or has no frame.
  double last_speed_m_per_s() const;
};

/// Trials of one test: for each mesh or factor all methods in the order of `trial_methods`.
using MethodTrials = std::vector<MethodTrial>;

/// Methods in the order of their years, then the paper's and this program's.
inline constexpr std::array trial_methods = {
    sim::SolverKind::ideal,           sim::SolverKind::provot, sim::SolverKind::implicit, sim::SolverKind::vassilev,
    sim::SolverKind::fast_projection, sim::SolverKind::strong, sim::SolverKind::bounded};

/// Triangles of the 9x9 cloth and of the coarse shirt.
inline constexpr int trial_grid_triangles = 128, trial_shirt_triangles = 1028;
/// Meshes of the test of time.
inline constexpr std::array trial_meshes = {trial_grid_triangles, trial_shirt_triangles, 5280, 10600};
inline constexpr std::array trial_step_factors = {1, 2, 5};
/// Threshold or bound of all methods that take one, a fraction.
inline constexpr double trial_max_stretch = 0.01;
/// Duration, amplitude and frequency of the pins' motion.
inline constexpr double shaken_s = 1.0, shaken_by_m = 0.03, shaken_hz = 3.0;

/// Lengths of the trials.
struct TrialLengths {
  int timed_frames = 12;
  double energy_s = 2.0;
  double shaking_s = shaken_s;  ///< whole number of half swings, after which pins are at their start positions
  double rest_s = 3.0;          ///< after the shaking
  double steps_s = 1.0;
};

/// Makes the trials of one test. Trials of time take turns of a few frames, so that other load on the machine affects
/// all methods equally; nothing else of the program should run meanwhile. Only they use `meshes`.
MethodTrials make_trials(MethodTest test, const ProgressCallback& report_progress, const TrialLengths& lengths = {},
                         std::span<const int> meshes = trial_meshes);

/// Returns the trial of this method with this factor or mesh. Throws std::out_of_range if there is none.
const MethodTrial& find_trial(const MethodTrials& trials, sim::SolverKind kind, int triangles = trial_shirt_triangles,
                              int step_factor = 1);

/// Counts of a model that is mapped to springs.
struct Mapping {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t structural = 0;      ///< number of springs
  std::size_t flexural = 0;        ///< number of springs
  std::size_t loose_vertices = 0;  ///< vertices without a spring
};

/// Result of one solver on a garment that starts as modelled.
struct TrialRun {
  double max_stretch_seen = 0.0;  ///< largest of all frames, a fraction; not finite if the run diverged
  double median_ms = 0.0;         ///< time per frame, while other experiments ran at the same time
};

/// A model that was read, mapped to springs and simulated.
struct GarmentTrial {
  std::string file;
  std::string kind;     ///< special property of the model
  std::string refusal;  ///< reason why it could not be read or mapped; if not empty, the members below are not set
  Mapping mapping;
  TrialRun strong;   ///< the paper's method, with equation (3) in full
  TrialRun bounded;  ///< `bounded` with the bound trial_bound
};

/// Frames of each trial.
inline constexpr int trial_frames = 45;
// Steps and sweeps of the paper's method.
inline constexpr int trial_steps = 20;
inline constexpr int trial_sweeps = 4;
/// Bound on stretch for `bounded`, a fraction.
inline constexpr double trial_bound = 0.05;

/// Reads a model file as every command does, hangs it by its top and simulates it with both solvers.
GarmentTrial try_garment(const std::string& file, const std::string& kind, const ProgressCallback& report_progress);

/// Tries the sample garments (assets/garments/samples) and the three shirts.
std::vector<GarmentTrial> try_garments(const ProgressCallback& report_progress);

/// Largest stretch of a run, a fraction; not finite if the run diverged.
struct StretchNumbers {
  double at_end = 0.0;      ///< last frame
  double on_the_way = 0.0;  ///< all frames
};

/// A run of the paper's method with a number of steps per frame and of sweeps per step.
struct StrongRun {
  std::string garment;
  /// true: equation (3) in full; false: springs yield to compression, so that cloth can fold.
  bool is_rigid = false;
  int substeps = 0;  ///< time steps per frame
  int sweeps = 0;    ///< sweeps over all springs per step
  StretchNumbers stretch;
  /// Largest values of all frames, for each member separately; not finite if the run diverged.
  sim::SurfaceStretch surface = {};
};

/// Compares an uninterrupted run with one that was continued from p(t) and p(t - dt) alone.
struct RestartRun {
  std::uint64_t uninterrupted_hash = 0;
  std::uint64_t restarted_hash = 0;
  int steps_before = 0;
  int steps_after = 0;
};

/// Runs the scene for `steps_before` steps, copies its two position arrays into a new state, then continues both for
/// `steps_after` steps.
RestartRun run_restart(const DrawnScene& scene, int steps_before, int steps_after);

/// Multiples of the stiffness of figure 7. The last is near the maximum that the short step allows.
inline constexpr std::array stiffness_factors = {1.0, 2.0, 4.0};

/// Growth of the shortest times with the number of triangles, by two laws. A geometric law multiplies the time by a
/// constant factor for each added triangle. A misfit is the root mean square residual of the logarithms of the times.
struct TimeGrowth {
  double exponent = 0.0;          ///< best power law
  double power_misfit = 0.0;      ///< best power law
  double geometric_misfit = 0.0;  ///< best geometric law
};
/// Fits both laws to the times measured with this number of substeps.
TimeGrowth measure_growth(const std::vector<FrameTimes>& times, int substeps);

/// Results for figure 8 and the claims, in addition to the results of the other figures.
struct ClaimResults : Results {
  std::vector<GarmentTrial> garments;
  /// Ideal springs with the short step, one run for each of stiffness_factors.
  std::vector<MethodRun> ideal_stiffnesses;
  std::vector<StrongRun> strong_runs;
  RestartRun restart;
  std::vector<TruthPoint> truth;
  std::array<MethodTrials, all_method_tests.size()> trials;  ///< one for each of MethodTest

  MethodTrials& trials_of(MethodTest test) { return trials[static_cast<std::size_t>(test)]; }
  const MethodTrials& trials_of(MethodTest test) const { return trials[static_cast<std::size_t>(test)]; }
};

/// Returns the simulations that figure 8 and the claims need, in the form of experiments().
std::vector<Job> claim_experiments(ClaimResults& results);

/// Returns the figure of the methods that the paper argues with, on the same shirts.
Figure make_figure8(ClaimResults& results);
/// Return and read the table of figure 8. Throw InputError that names the file and the line.
std::string figure8_csv(const ClaimResults& results);
void read_figure8(ClaimResults& results, const std::filesystem::path& folder);

/// Reads the tables of the figure of this name, if it has any, into the results, so that it can be drawn without its
/// experiments. Throws InputError that names the file and the line.
void read_figure(const std::string& name, const std::filesystem::path& folder, ClaimResults& results);

}  // namespace taut::app
