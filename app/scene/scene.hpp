#pragma once

#include <filesystem>

#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::app {

/// Unit of length.
struct Unit {
  const char* symbol;  ///< symbol that the option --units takes
  const char* name;
  double metres;  ///< length of the unit
};

/// Units of length that models use.
inline constexpr std::array units = {Unit{"m", "metre", 1.0},         Unit{"cm", "centimetre", 0.01},
                                     Unit{"mm", "millimetre", 0.001}, Unit{"dm", "decimetre", 0.1},
                                     Unit{"in", "inch", 0.0254},      Unit{"ft", "foot", 0.3048}};

/// A direction in a model's coordinates.
enum class ModelAxis { x, minus_x, y, minus_y, z, minus_z };

/// Names of the directions, indexed by ModelAxis.
inline constexpr std::array axis_names = {"x", "-x", "y", "-y", "z", "-z"};

/// Name of the solver in use, and settings of all solvers. A scene file may set settings before it names the solver.
struct SolverChoice {
  sim::SolverKind kind = sim::SolverKind::bounded;
  std::optional<int> substeps;                            ///< time steps per frame; empty: the solver chooses
  int max_substeps = sim::SolverSettings{}.max_substeps;  ///< limit for a solver that chooses
  /// Springs, which `provot`, `vassilev` and `fast-projection` use too.
  sim::IdealSettings ideal;
  sim::StrongSettings strong;
  /// Settings with the largest stretch, which `provot`, `vassilev` and `fast-projection` use too.
  sim::BoundedSettings bounded;
  sim::FastProjectionSettings fast_projection;  ///< other settings of this solver
  sim::ImplicitSettings implicit;

  bool operator==(const SolverChoice&) const = default;
};

/// Returns the settings of the solver in use.
sim::SolverSettings solver_settings(const SolverChoice& choice);

/// Returns the settings for another solver. The number of time steps is kept only for the scene's own solver, because
/// steps that are short enough for it may make another solver diverge; others choose their own.
SolverChoice with_solver(SolverChoice choice, sim::SolverKind kind, const SolverChoice& of_scene);

/// Returns the solver with this name; empty: none.
std::optional<sim::SolverKind> solver_named(std::string_view name);

/// Settings of a run's simulation.
struct RunSettings {
  double frame_rate_hz = sim::SimulationSettings{}.frame_rate_hz;
  SolverChoice solver;
  sim::RestSettings rest;

  bool operator==(const RunSettings&) const = default;
};

/// Converts the settings for sim::Simulation.
sim::SimulationSettings simulation_settings(const RunSettings& run);

struct ImportedModel;

/// Mesh of a model that is simulated.
enum class MeshChoice {
  automatic,  ///< the model if it can be simulated, else the fitted mesh
  model,      ///< the model's own triangles
  fitted,     ///< one clean wall of triangles made from the model, which then follows it
};

/// Source of the garment: a model file, or a regular grid if there is no file.
struct GarmentSource {
  std::filesystem::path file;       ///< empty: the grid
  std::filesystem::path sewn = {};  ///< garment that was sewn from the pattern `file` (app/garments/sewing); not a key
  std::optional<double> scale;      ///< metres per unit of the file; empty: the file's unit, or a guess
  std::optional<ModelAxis> up;      ///< direction in the file's coordinates; empty: the file's own, or a guess
  /// Distance in metres below which border vertices are merged; empty: only where parts clearly meet.
  std::optional<double> weld_m;
  MeshChoice mesh = MeshChoice::automatic;
  int max_triangles = 8000;    ///< limit for a fitted mesh
  bool is_drawn_finer = true;  ///< draws a finer surface if the model is coarser than its fitted mesh; not a key
  int subdivisions = 0;        ///< each divides a triangle into four; only for files
  /// Model file with the start positions of the garment's vertices, in metres with y up; empty: the garment starts as
  /// modelled.
  std::filesystem::path start;
  bool untangle = false;  ///< separates crossings of the start before the run
  sim::GridSettings grid;
  std::filesystem::path importer;  ///< program that reads the file (import_process.hpp); empty: Taut's own
  /// Model in metres with y up that replaces the file; null: none. It keeps its position and has no pins except those
  /// that the scene names. It is repaired like a model from a file.
  std::shared_ptr<const ImportedModel> given;
  /// Start positions that replace the file `start`, per vertex of `given` or else of the simulated mesh; null: none.
  std::shared_ptr<const std::vector<sim::Vec3>> given_start_m;

  /// Returns the file that is read as a model.
  const std::filesystem::path& model() const { return sewn.empty() ? file : sewn; }
  bool has_start() const { return !start.empty() || given_start_m; }
  /// Returns true if the garment is the grid.
  bool is_grid() const { return file.empty() && !given; }
};

/// Selects the vertex nearest to a point.
struct NearestTo {
  sim::Vec3 point_m = {0.0, 0.0, 0.0};
};

/// Vertices to pin: a landmark or a name of pin_names() (pins.hpp), a vertex of the garment's file (file_mesh.hpp), or
/// the vertex nearest to a point.
using PinSelector = std::variant<std::string, sim::Index, NearestTo>;

/// Pins with a motion of their own.
struct MovingPinsInScene {
  std::vector<PinSelector> at;
  sim::RigidMotion motion;
};

/// Source of a body's mesh and motion.
struct BodySource {
  std::filesystem::path file;
  std::optional<double> scale;  ///< metres per unit of the file; empty: the file's unit, or else metres
  std::optional<ModelAxis> up;  ///< direction in the file's coordinates; empty: the file's own, or else y
  /// PC2 or BVH file; empty: an animation of the model file, or none.
  std::filesystem::path motion;
  std::string clip;  ///< name of an animation in the file; empty: the first; "none": the body keeps its pose
  std::optional<double> frame_rate_hz;  ///< empty: the motion's rate, or else 60
  double start_s = 0.0;                 ///< time in the motion at which the run begins
  bool loop = false;                    ///< repeats the motion after its last frame instead of staying there
  int dress = 0;                        ///< frames of the scene before the run in which the body grows into the clothes
  std::filesystem::path importer;       ///< see GarmentSource
};

/// A body as a scene file describes it. Its mesh is given by the caller, or else read by load_bodies().
struct BodyInScene {
  sim::Body body;
  BodySource source = {};  ///< used for meshes
};

/// Contents of a scene file, as the simulation needs them. DrawnScene adds how it is drawn. LoadedBodies and
/// LoadedGarment hold what is read from the files that it names.
struct Scene {
  std::string name;  ///< the user's name for it; not a key of the file
  std::string title;
  GarmentSource garment;
  sim::MappingSettings mapping;
  sim::Material material;
  std::string fabric;                            ///< name or file that set `material` and the look; empty: none
  std::optional<std::vector<PinSelector>> pins;  ///< empty: the garment is pinned at its top
  double pin_width_m = 0.0;                      ///< width around each of `pins` in which cloth is pinned
  std::vector<MovingPinsInScene> moving_pins;    ///< added to `pins`
  RunSettings simulation;
  sim::Surroundings surroundings;  ///< without bodies and moving pins, which settle_surroundings() adds
  std::vector<BodyInScene> bodies;
  std::filesystem::path checkpoint;  ///< saved state to start from (run_checkpoint.hpp); empty: none
  int frames = 600;                  ///< frames of the run
  /// Files that were read in addition to those in the members: the scene's own, and the files that these name; not a
  /// key.
  std::vector<std::filesystem::path> files_read;

  /// Returns the number of frames before frame 0, in which bodies grow into the clothes.
  int dressing_frames() const;
};

/// Returns the scene's bodies without the meshes of files.
std::vector<sim::Body> named_bodies(const Scene& scene);

/// Returns the reason why the `bounded` solver cannot promise its bound for this scene. Empty if it can, if the scene
/// has no bound, or if the scene allows exceeding it.
std::optional<std::string> unpromised_bound_reason(const Scene& scene);

/// Returns the reason why the `bounded` solver does not keep layers of this scene's cloth apart: it is too thin, or too
/// thick for its mesh. Empty if it keeps them apart or need not.
std::optional<std::string> missing_contact_reason(const Scene& scene, const sim::Garment& garment);

/// Returns the largest stretch that the scene's solver tries to keep, a fraction; empty if it has none.
std::optional<double> stretch_bound(const Scene& scene);

/// Returns the measure that the bound limits. For every solver other than `bounded` it is the springs.
sim::BoundKind bound_kind(const Scene& scene);

/// Returns "bound" if the solver keeps it, "threshold" if springs are only pulled back to it.
const char* bound_word(const Scene& scene);

}  // namespace taut::app
