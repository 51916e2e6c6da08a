#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/base/job_runner.hpp"
#include "app/figures/experiments/garment_trials.hpp"
#include "app/figures/experiments/power_law.hpp"
#include "app/figures/experiments/recording.hpp"
#include "app/figures/experiments/spring_patch.hpp"
#include "sim/solvers/make_solver.hpp"

namespace taut::app {

/// A method run on the cloth of figure 7, measured after every time step.
struct MethodRun {
  sim::SolverKind kind = sim::SolverKind::strong;
  double time_step_s = 0.0;
  std::vector<double> max_stretch;
  std::vector<double> moved_rms_m;  ///< root mean square of |p(t) - p(t - dt)| over the vertices
  std::optional<double> diverged_at_s;
  double stiffness_n_per_m = 0.0;  ///< of structural springs, where the method has any
};

/// How the springs of a method behave when the cloth should long be at rest: over the last quarter of a run.
struct Unrest {
  double speed_m_per_s = 0.0;     ///< root mean square movement of a step over the step
  double smallest_stretch = 0.0;  ///< of the largest stretch, which goes up and down where springs vibrate
  double largest_stretch = 0.0;
};

/// Nothing for a run that diverged.
std::optional<Unrest> measure_unrest(const MethodRun& run);

/// The largest stretch of a run's last frame and of all its frames; not finite where it diverged.
struct StretchNumbers {
  double at_end = 0.0;
  double on_the_way = 0.0;
};

/// What the paper's method makes of a cloth with so many steps a frame and sweeps a step.
struct StrongRun {
  std::string garment;
  bool is_rigid = false;  ///< equation (3) in full; else springs give way to compression, so that cloth folds
  int substeps = 0;
  int sweeps = 0;
  StretchNumbers stretch;
};

/// A run that was taken up in the middle from nothing but p(t) and p(t - dt).
struct RestartRun {
  std::uint64_t uninterrupted_hash = 0;
  std::uint64_t restarted_hash = 0;
  int steps_before = 0;
  int steps_after = 0;
};

double median(std::vector<double> values);

/// Frame times of one model and one setting of the solver.
struct FrameTimes {
  int triangles = 0;
  int substeps = 0;  ///< of `bounded`, which chooses them: 0, and no sweeps
  int sweeps = 0;
  std::vector<double> frame_ms;
  double largest_stretch = 0.0;  ///< of the frames that were timed; not read back from a table

  double median_ms() const;
  double shortest_ms() const;
  double longest_ms() const;
};

/// Everything the figures and the report are made from. A part is there once its experiment has been made.
struct Results {
  SpringPatch grid_patch;
  SpringPatch shirt_patch;
  std::vector<GarmentTrial> garments;
  std::optional<StepRecording> fall;
  std::array<std::optional<Recording>, 2> pinned;
  std::array<std::optional<Recording>, 3> shirts;
  std::vector<MethodRun> methods;            ///< three methods with the short step, then with the long one
  std::vector<MethodRun> ideal_stiffnesses;  ///< ideal springs with the short step, `stiffness_factors`
  std::vector<StrongRun> strong_runs;
  RestartRun restart;
  std::vector<FrameTimes> frame_times;    ///< of the paper's method
  std::vector<FrameTimes> bounded_times;  ///< of `bounded`, the same shirts and moments
};

enum class Experiment {
  mapping,
  fall,
  pinned_5,
  pinned_20,
  shirt_still,
  shirt_wind_1,
  shirt_wind_10,
  methods,
  stiffnesses,
  strong_runs,
  garments,
  restart,
};

/// The experiment as a job that fills its own part of the results and touches no other.
Job job_of(Experiment experiment, Results& results);

// Scenes of figures 2 to 5.
inline constexpr const char* fall_scene = "cloth-fall";
inline constexpr std::array pinned_scenes = {"pinned-9x9-5", "pinned-9x9-20"};
inline constexpr std::array shirt_scenes = {"tshirt-gravity", "tshirt-wind-1", "tshirt-wind-10"};

/// The vertex that figure 3 follows: the middle of the free edge of the falling cloth.
sim::Index followed_vertex(const DrawnScene& scene);

/// Steps a second of figure 7, and how long its runs are.
inline constexpr std::array method_rates_hz = {640.0, 160.0};
inline constexpr double methods_duration_s = 10.0;
/// What the paper sets against each other in its section III.
inline constexpr std::array compared_methods = {sim::SolverKind::ideal, sim::SolverKind::provot,
                                                sim::SolverKind::strong};
MethodRun run_method(sim::SolverKind kind, double steps_per_s, double duration_s,
                     double stiffness_factor = 1.0);
/// Times the stiffness of figure 7: the last is near the most that its short step allows.
inline constexpr std::array stiffness_factors = {1.0, 2.0, 4.0};

/// Runs the scene to the middle, copies its two position arrays into a new state, and goes on from both.
RestartRun run_restart(const DrawnScene& scene, int steps_before, int steps_after);

/// The three shirts under gravity, without layers, in turn and several times over, with the paper's method
/// and with `bounded`. To be measured while nothing else runs.
void measure_frame_times(int repeats, const Checkpoint& checkpoint, Results& results);

/// ms = factor * triangles^exponent, through the shortest times.
/// Other programs can only lengthen a time: on a busy machine medians bend the law, the shortest hardly do.
PowerLaw fit_power_law(const std::vector<FrameTimes>& times, int substeps);

/// How the shortest times grow with the triangles. A geometric law multiplies the time by the same factor for
/// every triangle more.
struct TimeGrowth {
  double exponent = 0.0;          ///< of the power law that fits best
  double power_misfit = 0.0;      ///< of that law, and of the geometric one: root mean square distance of the
  double geometric_misfit = 0.0;  ///< logarithms of the times
};
TimeGrowth measure_growth(const std::vector<FrameTimes>& times, int substeps);

/// A built-in scene with another model of the shirt.
DrawnScene shirt_scene(const std::string& name, int triangles);

/// The shirt under gravity by the paper's method, which figure 6 and the report try to its limits.
DrawnScene strong_shirt_scene(int triangles);
inline constexpr std::array model_sizes = {1028, 5280, 10600};

}  // namespace taut::app
