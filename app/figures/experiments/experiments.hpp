#pragma once

#include "app/figures/experiments/recording.hpp"
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

/// Makes the trials of one test. Those of time take turns of a few frames, so that other load on the machine
/// meets all methods alike; nothing else of the program should run meanwhile. `meshes` are theirs alone.
MethodTrials make_trials(MethodTest test, const ProgressCallback& report_progress, const TrialLengths& lengths = {},
                         std::span<const int> meshes = trial_meshes);

/// The trial of this method among others, with this factor or mesh. Throws std::out_of_range without one.
const MethodTrial& trial_of(const MethodTrials& trials, sim::SolverKind kind, int triangles = trial_shirt_triangles,
                            int step_factor = 1);

/// y = offset + slope * x.
struct StraightLine {
  double slope = 0.0;
  double offset = 0.0;
  double misfit = 0.0;  ///< root mean square distance of the points along y
};

/// Fits a line by least squares. The points need at least two different x; otherwise no member is finite.
StraightLine fit_line(std::span<const std::array<double, 2>> points);

/// y = factor * x^exponent.
struct PowerLaw {
  double exponent = 0.0;
  double factor = 0.0;
  double misfit = 0.0;  ///< root mean square distance of the logarithms of y
};

/// Fits the law by least squares on the logarithms of x and y. All coordinates must be above 0, with at least
/// two different x; otherwise no member is finite.
PowerLaw fit_power_law(std::span<const std::array<double, 2>> points);

/// One spring of a patch.
struct PatchSpring {
  std::array<std::size_t, 2> ends;  ///< indices of points of the patch
  sim::SpringKind kind;
};

/// Mass points and springs of a part of a garment, in a plane, for a diagram.
struct SpringPatch {
  std::vector<glm::vec2> points_m;  ///< x to the right, y up
  std::vector<PatchSpring> springs;

  /// How many springs of this kind there are.
  std::size_t count(sim::SpringKind kind) const;
};

/// All points and springs of a garment that lies in the xy plane.
SpringPatch whole_patch(const sim::Garment& garment);

/// The vertices within `rings` edges of a vertex, with their springs. Seen along the surface's normal at the
/// vertex.
SpringPatch patch_around(const sim::Garment& garment, sim::Index vertex, int rings);

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

/// A run of one method on the cloth of figure 7. It is measured after every time step; vectors have one entry
/// per step.
struct MethodRun {
  sim::SolverKind kind = sim::SolverKind::strong;
  double time_step_s = 0.0;
  std::vector<double> max_stretch;      ///< of all springs, a fraction
  std::vector<double> moved_rms_m;      ///< root mean square of |p(t) - p(t - dt)| over the vertices
  std::optional<double> diverged_at_s;  ///< simulated time; empty: it did not diverge
  double stiffness_n_per_m = 0.0;       ///< of structural springs; 0 for a method without
};

/// How much the cloth still moves when it should be at rest, measured over the last quarter of a run.
struct Unrest {
  double speed_m_per_s = 0.0;  ///< root mean square movement in a step, divided by the step
  /// Smallest value of the largest stretch of a step. It differs from `largest_stretch` if springs vibrate.
  double smallest_stretch = 0.0;
  double largest_stretch = 0.0;  ///< Largest value of the largest stretch of a step.
};

/// Empty if the run diverged.
std::optional<Unrest> measure_unrest(const MethodRun& run);

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

/// How long frames of one model take with one setting of the solver.
struct FrameTimes {
  int triangles = 0;
  int substeps = 0;              ///< time steps per frame; 0 for `bounded`, which chooses them
  int sweeps = 0;                ///< per step; 0 for `bounded`
  std::vector<double> frame_ms;  ///< processor time, one entry per repeat
  double largest_stretch = 0.0;  ///< of the frames that were timed; not stored in tables

  double median_ms() const;
  double shortest_ms() const;
  double longest_ms() const;
};

/// Everything the figures and the report are made from. Each experiment fills its own members.
struct Results {
  SpringPatch grid_patch;
  SpringPatch shirt_patch;
  std::vector<GarmentTrial> garments;
  std::optional<StepRecording> fall;
  std::array<std::optional<Recording>, 2> pinned;  ///< of pinned_scenes
  std::array<std::optional<Recording>, 3> shirts;  ///< of shirt_scenes
  std::vector<MethodRun> methods;                  ///< compared_methods with the short step, then with the long step
  /// Ideal springs with the short step, one run for each of stiffness_factors.
  std::vector<MethodRun> ideal_stiffnesses;
  std::vector<StrongRun> strong_runs;
  RestartRun restart;
  std::vector<FrameTimes> frame_times;                       ///< of the paper's method
  std::vector<FrameTimes> bounded_times;                     ///< of `bounded`, on the same shirts and frames
  std::array<MethodTrials, all_method_tests.size()> trials;  ///< one for each of MethodTest

  MethodTrials& trials_of(MethodTest test) { return trials[static_cast<std::size_t>(test)]; }
  const MethodTrials& trials_of(MethodTest test) const { return trials[static_cast<std::size_t>(test)]; }
};

/// Simulations that figures and the report need.
enum class Experiment {
  mapping,
  fall,
  pinned_5,
  pinned_20,
  shirt_still,
  shirt_wind_1,
  shirt_wind_10,
  methods,
  methods_energy,
  methods_rest,
  methods_steps,
  stiffnesses,
  strong_runs,
  garments,
  restart,
};

/// The experiment as a job. It fills its own part of `results` and touches no other part, so jobs may run in
/// parallel.
Job job_of(Experiment experiment, Results& results);

// Scenes of figures 2 to 5.
inline constexpr const char* fall_scene = "cloth-fall";
inline constexpr std::array pinned_scenes = {"pinned-9x9-5", "pinned-9x9-20"};
inline constexpr std::array shirt_scenes = {"tshirt-gravity", "tshirt-wind-1", "tshirt-wind-10"};

/// The vertex that figure 3 follows: the middle of the falling cloth's free edge.
sim::Index followed_vertex(const DrawnScene& scene);

/// Time steps per second of figure 7: the short step and the long step.
inline constexpr std::array method_rates_hz = {640.0, 160.0};
/// Simulated time of each of its runs.
inline constexpr double methods_duration_s = 10.0;
/// The methods that the paper compares in its section III.
inline constexpr std::array compared_methods = {sim::SolverKind::ideal, sim::SolverKind::provot,
                                                sim::SolverKind::strong};
/// Runs a method on the cloth of figure 7. `stiffness_factor` multiplies the stiffness of its springs.
MethodRun run_method(sim::SolverKind kind, double steps_per_s, double duration_s, double stiffness_factor = 1.0);
/// Multiples of the stiffness of figure 7. The last one is near the most that the short step allows.
inline constexpr std::array stiffness_factors = {1.0, 2.0, 4.0};

/// Runs the scene for `steps_before` steps and copies its two position arrays into a new state. Then
/// continues both for `steps_after` steps.
RestartRun run_restart(const DrawnScene& scene, int steps_before, int steps_after);

/// Measures frames of the three shirts under gravity, without contact, by the paper's method and by
/// `bounded`. The shirts take turns, `repeats` times. Nothing else should run meanwhile. Fills frame_times
/// and bounded_times.
void measure_frame_times(int repeats, const ProgressCallback& report_progress, Results& results);

/// Fits ms = factor * triangles^exponent to the shortest time of each model. Other programs can only lengthen
/// a time. So on a busy machine the shortest times are more reliable than the medians.
PowerLaw fit_power_law(const std::vector<FrameTimes>& times, int substeps);

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

/// A built-in scene with the shirt model that has this number of triangles.
DrawnScene shirt_scene(const std::string& name, int triangles);

/// The shirt under gravity, simulated by the paper's method. Figure 6 and the report use it.
DrawnScene strong_shirt_scene(int triangles);
/// Triangles of the paper's models.
inline constexpr std::array model_sizes = {1028, 5280, 10600};

}  // namespace taut::app
