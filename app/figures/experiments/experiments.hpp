#pragma once

#include "app/base/job_runner.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/runs/frame_record.hpp"
#include "app/verify/stretch.hpp"

namespace taut::app {

/// A frame of a run: measurements, and positions in metres per vertex.
struct Moment {
  FrameRecord record;
  std::vector<sim::Vec3> positions;
};

/// Counts of FrameVerifier, which shares no code with the solvers, over the frames of a run.
struct PromiseCounts {
  int frames = 0;                  ///< checked frames
  LargestStretch stretch;          ///< largest stretch of all frames
  std::size_t crossing_pairs = 0;  ///< sum of all frames
  std::size_t max_pairs = 0;       ///< crossing pairs of the worst frame
  int crossing_frames = 0;         ///< frames with crossing pairs
};

/// Selected frames of a run, to draw figures from.
struct Recording {
  DrawnScene scene;
  std::shared_ptr<const sim::Garment> garment;
  std::vector<sim::Index> pins;
  std::vector<Moment> moments;   ///< selected frames, ascending
  double max_stretch_seen = 0.0;  ///< largest of all frames of the run, a fraction
  /// Largest values of all frames, for each member separately.
  sim::SurfaceStretch max_surface_stretch;
  std::optional<PromiseCounts> promises;  ///< empty: not counted

  const Moment& last() const { return moments.back(); }
};

/// Updates the largest stretches of a recording with a frame.
void add_stretch(const FrameRecord& record, Recording& recording);

/// Checks of every frame. Checking promises takes about as long as simulating the frame.
enum class Checking { none, promises };

/// Simulates the scene up to the last of `frames`, which must be ascending, and keeps these frames.
Recording record_frames(const DrawnScene& scene, std::span<const int> frames, const ProgressCallback& report_progress,
                        Checking checking = Checking::none);

/// A run that was measured after every time step, which the paper calls an iteration.
struct StepRecording {
  Recording frames;
  double time_step_s = 0.0;
  sim::Index vertex = 0;        ///< followed vertex
  std::vector<double> moved_m;  ///< |p(t) - p(t - dt)| of the followed vertex in metres, one entry per step
  bool came_to_rest = false;    ///< the cloth fell asleep (sim::State)
};

/// Simulates the scene until it is at rest, at most up to the last of `frames`, which must be ascending, and keeps
/// these frames. If the cloth comes to rest earlier, that moment replaces the frames after it.
StepRecording record_steps(const DrawnScene& scene, std::span<const int> frames, sim::Index vertex,
                           const ProgressCallback& report_progress, Checking checking = Checking::none);

/// Returns the scene with each time step as a frame of its own. The length of a step does not change.
DrawnScene with_steps_as_frames(DrawnScene scene);

/// Frames of the scene cloth-fall in figure 2: the fall, the swing to the far side and back, and the cloth at rest. The
/// cloth comes to rest some time before the last of these frames.
inline constexpr std::array fall_frames = {0, 12, 21, 30, 40, 54, 80, 900};

/// The cloth of figures 2 and 3 counts as at rest when it moves less than `fall_rest_m` (root mean square over the
/// vertices) in `fall_rest_s`. The swing shrinks to a tenth every two seconds, and one this small is invisible. A
/// larger value ends the run earlier.
inline constexpr double fall_rest_m = 1e-4;
inline constexpr double fall_rest_s = 0.5;

/// Line y = offset + slope * x.
struct StraightLine {
  double slope = 0.0;
  double offset = 0.0;
  double rms_residual = 0.0;  ///< root mean square residual of y
};

/// Fits a line by least squares. The points need at least two different x; otherwise no member is finite.
StraightLine fit_line(std::span<const std::array<double, 2>> points);

/// Power law y = factor * x^exponent.
struct PowerLaw {
  double exponent = 0.0;
  double factor = 0.0;
  double rms_residual = 0.0;  ///< root mean square residual of log y
};

/// Fits the law by least squares on the logarithms of x and y. All coordinates must be above 0, with at least two
/// different x; otherwise no member is finite.
PowerLaw fit_power_law(std::span<const std::array<double, 2>> points);

/// Spring of a patch.
struct PatchSpring {
  std::array<std::size_t, 2> ends;  ///< indices of the patch's points
  sim::SpringKind kind;
};

/// Mass points and springs of a part of a garment, projected to a plane for a diagram.
struct SpringPatch {
  std::vector<glm::vec2> points_m;  ///< x to the right, y up
  std::vector<PatchSpring> springs;

  /// Returns the number of springs of this kind.
  std::size_t count(sim::SpringKind kind) const;
};

/// Returns all points and springs of a garment that lies in the xy plane.
SpringPatch whole_patch(const sim::Garment& garment);

/// Returns the vertices within `rings` edges of a vertex and their springs, viewed along the surface's normal there.
SpringPatch patch_around(const sim::Garment& garment, sim::Index vertex, int rings);

/// A run of a method on the cloth of figure 7. Vectors have one entry per time step.
struct MethodRun {
  sim::SolverKind kind = sim::SolverKind::strong;
  double time_step_s = 0.0;
  std::vector<double> max_stretch;      ///< largest of all springs, a fraction
  std::vector<double> moved_rms_m;      ///< root mean square of |p(t) - p(t - dt)| over the vertices, in metres
  std::optional<double> diverged_at_s;  ///< simulated time in seconds; empty: the run did not diverge
  double stiffness_n_per_m = 0.0;       ///< stiffness of structural springs; 0: the method has none
};

/// Residual motion of cloth that should be at rest, over the last quarter of a run.
struct Unrest {
  double speed_m_per_s = 0.0;    ///< root mean square movement in a step, divided by the step
  double max_stretch_seen = 0.0;  ///< largest stretch of any step, a fraction
};

/// Returns nothing if the run diverged.
std::optional<Unrest> measure_unrest(const MethodRun& run);

/// Frame times of one model with one setting of the solver.
struct FrameTimes {
  int triangles = 0;
  int substeps = 0;              ///< time steps per frame; 0 for `bounded`, which chooses them
  int sweeps = 0;                ///< sweeps per step; 0 for `bounded`
  std::vector<double> frame_ms;  ///< CPU time, one entry per repeat
  double max_stretch_seen = 0.0;  ///< largest of the timed frames, a fraction; not stored in tables

  double median_ms() const;
  double min_ms() const { return *std::ranges::min_element(frame_ms); }
  double max_ms() const { return *std::ranges::max_element(frame_ms); }
};

/// Results that the figures are made from. Each experiment fills its own members.
struct Results {
  SpringPatch grid_patch;
  SpringPatch shirt_patch;
  std::optional<StepRecording> fall;
  std::array<std::optional<Recording>, 2> pinned;  ///< one for each of pinned_scenes
  std::array<std::optional<Recording>, 3> shirts;  ///< one for each of shirt_scenes
  std::vector<MethodRun> methods;                  ///< compared_methods with the short step, then with the long step
  std::vector<FrameTimes> frame_times;             ///< times of the paper's method
  std::vector<FrameTimes> bounded_times;           ///< times of `bounded` on the same shirts and frames
};

/// Returns the simulations that figures need, by the names in Figure::needs. Each fills its own part of `results`, so
/// that they may run in parallel.
std::vector<Job> experiments(Results& results, Checking checking = Checking::none);

// Scenes of figures 2 to 5.
inline constexpr const char* fall_scene = "cloth-fall";
inline constexpr std::array pinned_scenes = {"pinned-9x9-5", "pinned-9x9-20"};
inline constexpr std::array shirt_scenes = {"tshirt-gravity", "tshirt-wind-1", "tshirt-wind-10"};

/// The vertex that figure 3 follows: the middle of the falling cloth's free edge.
sim::Index followed_vertex(const DrawnScene& scene);

/// Time steps per second in figure 7: the short step and the long step.
inline constexpr std::array method_rates_hz = {640.0, 160.0};
/// Simulated time of each run in figure 7.
inline constexpr double methods_duration_s = 10.0;
/// Methods that the paper compares in its section III.
inline constexpr std::array compared_methods = {sim::SolverKind::ideal, sim::SolverKind::provot,
                                                sim::SolverKind::strong};
/// Runs a method on the cloth of figure 7. `stiffness_factor` multiplies the stiffness of its springs.
MethodRun run_method(sim::SolverKind kind, double steps_per_s, double duration_s, double stiffness_factor = 1.0);

/// Measures frames of the three shirts under gravity, without contact, by the paper's method and by `bounded`. The
/// shirts take turns, `repeats` times. Nothing else should run meanwhile. Fills frame_times and bounded_times.
void measure_frame_times(int repeats, const ProgressCallback& report_progress, Results& results);

/// Fits ms = factor * triangles^exponent to the shortest time of each model. Other programs can only lengthen a time,
/// so on a busy machine the shortest times are more reliable than the medians.
PowerLaw fit_power_law(const std::vector<FrameTimes>& times, int substeps);

/// Returns a built-in scene with the shirt model of this number of triangles.
DrawnScene shirt_scene(const std::string& name, int triangles);

/// Returns the shirt under gravity, simulated by the paper's method, as in figure 6.
DrawnScene strong_shirt_scene(int triangles);
/// Triangle counts of the paper's models.
inline constexpr std::array model_sizes = {1028, 5280, 10600};

}  // namespace taut::app
