#pragma once

#include "app/base/job_runner.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/output/frame_record.hpp"
#include "app/verify/stretch.hpp"

namespace taut::app {

/// One frame of a run: what was measured, and the positions in metres, per vertex.
struct Moment {
  FrameRecord record;
  std::vector<sim::Vec3> positions;
};

/// Counts in the frames of a run by FrameVerifier, which shares nothing with the solvers.
struct PromiseCounts {
  int frames = 0;                  ///< that were checked
  LargestStretch stretch;          ///< of all of them
  std::size_t crossing_pairs = 0;  ///< the sum of all of them
  std::size_t most_pairs = 0;      ///< in the frame with the most
  int crossing_frames = 0;         ///< in which something crosses
};

/// Selected frames of a run, from which figures are drawn.
struct Recording {
  DrawnScene scene;
  std::shared_ptr<const sim::Garment> garment;
  std::vector<sim::Index> pins;
  std::vector<Moment> moments;   ///< the selected frames, ascending
  double largest_stretch = 0.0;  ///< of all frames of the run, a fraction
  /// The largest of all frames, each member by itself.
  sim::SurfaceStretch largest_surface_stretch;
  std::optional<PromiseCounts> promises;  ///< empty: nobody has counted

  const Moment& last() const { return moments.back(); }
};

/// Takes the stretches of one more frame into the largest of a recording.
void note_stretch(const FrameRecord& record, Recording& recording);

/// Whether every frame is checked for what is promised; it costs about as much as the frame.
enum class Checking { none, promises };

/// Simulates the scene up to the last of `frames`, which must be ascending, and keeps these frames.
Recording record_frames(const DrawnScene& scene, std::span<const int> frames, const ProgressCallback& report_progress,
                        Checking checking = Checking::none);

/// A run that was looked at after every time step. The paper calls a step an iteration.
struct StepRecording {
  Recording frames;
  double time_step_s = 0.0;
  sim::Index vertex = 0;        ///< the vertex that was followed
  std::vector<double> moved_m;  ///< p(t) - p(t - dt)| of the vertex, one entry per step
  bool came_to_rest = false;    ///< as moments.hpp defines it
};

/// Simulates the scene until it is at rest, but not beyond the last of `frames`, which must be ascending. It
/// keeps these frames. If the cloth comes to rest earlier, that moment replaces the frames after it.
StepRecording record_steps(const DrawnScene& scene, std::span<const int> frames, sim::Index vertex,
                           const ProgressCallback& report_progress, Checking checking = Checking::none);

/// The scene with one time step per frame, where the steps keep their length. So each step becomes a frame.
DrawnScene with_steps_as_frames(DrawnScene scene);

/// Frames of the scene cloth-fall in figure 2: the fall, the swing to the far side and back, and the cloth at
/// rest. It comes to rest some time before the last of these frames.
inline constexpr std::array fall_frames = {0, 12, 21, 30, 40, 54, 80, 900};

/// In figures 2 and 3 the cloth counts as at rest if it stays within `fall_rest_m` (root mean square over the
/// vertices) for `fall_rest_s`. The swing shrinks to a tenth every two seconds, and such a small one cannot
/// be seen. A larger value ends the run earlier.
inline constexpr double fall_rest_m = 1e-4;
inline constexpr double fall_rest_s = 0.5;

/// Frames of the scene tshirt-wind-10 in figure 5. A shirt in this wind never comes to rest, so a longer run
/// would only cost more.
inline constexpr int strong_wind_frames = 100;

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
  double speed_m_per_s = 0.0;    ///< root mean square movement in a step, divided by the step
  double largest_stretch = 0.0;  ///< Largest value of the largest stretch of a step.
};

/// Empty if the run diverged.
std::optional<Unrest> measure_unrest(const MethodRun& run);

/// How long frames of one model take with one setting of the solver.
struct FrameTimes {
  int triangles = 0;
  int substeps = 0;              ///< time steps per frame; 0 for `bounded`, which chooses them
  int sweeps = 0;                ///< per step; 0 for `bounded`
  std::vector<double> frame_ms;  ///< processor time, one entry per repeat
  double largest_stretch = 0.0;  ///< of the frames that were timed; not stored in tables

  double median_ms() const;
  double shortest_ms() const { return *std::ranges::min_element(frame_ms); }
  double longest_ms() const { return *std::ranges::max_element(frame_ms); }
};

/// Everything the figures are made from. Each experiment fills its own members.
struct Results {
  SpringPatch grid_patch;
  SpringPatch shirt_patch;
  std::optional<StepRecording> fall;
  std::array<std::optional<Recording>, 2> pinned;  ///< of pinned_scenes
  std::array<std::optional<Recording>, 3> shirts;  ///< of shirt_scenes
  std::vector<MethodRun> methods;                  ///< compared_methods with the short step, then with the long step
  std::vector<FrameTimes> frame_times;             ///< of the paper's method
  std::vector<FrameTimes> bounded_times;           ///< of `bounded`, on the same shirts and frames
};

/// The simulations that figures need, by the names in Figure::needs. Each fills its own part of `results` and
/// touches no other, so that they may run in parallel.
std::vector<Job> experiments(Results& results, Checking checking = Checking::none);

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

/// Measures frames of the three shirts under gravity, without contact, by the paper's method and by
/// `bounded`. The shirts take turns, `repeats` times. Nothing else should run meanwhile. Fills frame_times
/// and bounded_times.
void measure_frame_times(int repeats, const ProgressCallback& report_progress, Results& results);

/// Fits ms = factor * triangles^exponent to the shortest time of each model. Other programs can only lengthen
/// a time. So on a busy machine the shortest times are more reliable than the medians.
PowerLaw fit_power_law(const std::vector<FrameTimes>& times, int substeps);

/// A built-in scene with the shirt model that has this number of triangles.
DrawnScene shirt_scene(const std::string& name, int triangles);

/// The shirt under gravity, simulated by the paper's method, as figure 6 has it.
DrawnScene strong_shirt_scene(int triangles);
/// Triangles of the paper's models.
inline constexpr std::array model_sizes = {1028, 5280, 10600};

}  // namespace taut::app
