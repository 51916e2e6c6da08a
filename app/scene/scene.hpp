#pragma once

#include <filesystem>

#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::app {

/// A unit of length.
struct Unit {
  const char* symbol;  ///< as the option --units takes it
  const char* name;
  double metres;  ///< length of the unit
};

/// Units a model may be in.
inline constexpr std::array units = {Unit{"m", "metre", 1.0},         Unit{"cm", "centimetre", 0.01},
                                     Unit{"mm", "millimetre", 0.001}, Unit{"dm", "decimetre", 0.1},
                                     Unit{"in", "inch", 0.0254},      Unit{"ft", "foot", 0.3048}};

/// A direction in a model's own coordinates.
enum class ModelAxis { x, minus_x, y, minus_y, z, minus_z };

/// Names of the directions, indexed by ModelAxis.
inline constexpr std::array axis_names = {"x", "-x", "y", "-y", "z", "-z"};

/// Settings of all solvers, and which solver is used. All are kept because a scene file may name the solver
/// after its settings.
struct SolverChoice {
  sim::SolverKind kind = sim::SolverKind::bounded;
  std::optional<int> substeps;                            ///< time steps per frame; empty: the solver chooses
  int max_substeps = sim::SolverSettings{}.max_substeps;  ///< the most that a solver may choose
  /// `provot`, `vassilev` and `fast-projection` use these springs too.
  sim::IdealSettings ideal;
  sim::StrongSettings strong;
  /// `provot`, `vassilev` and `fast-projection` use this largest stretch too.
  sim::BoundedSettings bounded;
  sim::FastProjectionSettings fast_projection;  ///< without what is used of the others
  sim::ImplicitSettings implicit;

  bool operator==(const SolverChoice&) const = default;
};

/// The settings of the solver that is used.
sim::SolverSettings solver_settings(const SolverChoice& choice);

/// The same settings for another solver. Time steps that are short enough for one solver may make another fly
/// apart: a number of them stands for the solver that the scene has it for, and any other chooses its own.
SolverChoice with_solver(SolverChoice choice, sim::SolverKind kind, const SolverChoice& of_scene);

/// The solver that has this name; empty if none has.
std::optional<sim::SolverKind> solver_named(std::string_view name);

/// How a scene is simulated.
struct RunSettings {
  double frame_rate_hz = sim::SimulationSettings{}.frame_rate_hz;
  SolverChoice solver;
  sim::RestSettings rest;

  bool operator==(const RunSettings&) const = default;
};

/// The same settings as the simulation takes them.
sim::SimulationSettings simulation_settings(const RunSettings& run);

struct ImportedModel;
struct Wearer;

/// Which mesh of a model is simulated.
enum class MeshChoice {
  automatic,  ///< the model where it is fit for it, else the fitted one
  model,      ///< the model's own triangles
  fitted,     ///< one clean wall that is made of the model, which follows it
};

/// Where the garment comes from: a model file, or a regular grid if no file is named.
struct GarmentSource {
  std::filesystem::path file;       ///< empty: the grid
  std::filesystem::path sewn = {};  ///< of a sewing pattern, the garment that was made of it (app/sewing); not a key
  std::optional<double> scale;      ///< metres per unit of the file; empty: the file's own unit, or a guess
  std::optional<ModelAxis> up;      ///< in the file's coordinates; empty: the file's own, or a guess
  /// Vertices of borders that are closer than this become one; empty: where parts meet beyond doubt.
  std::optional<double> weld_m;
  MeshChoice mesh = MeshChoice::automatic;
  int most_triangles = 8000;   ///< of a fitted mesh
  bool is_drawn_finer = true;  ///< where its model is coarser than the mesh that is fitted to it; no key
  int subdivisions = 0;        ///< each makes four triangles of one; only for a file
  /// Model file with the positions at the start: the garment's vertices, in metres with y up. Empty: the
  /// garment starts as it was modelled.
  std::filesystem::path start;
  bool untangle = false;  ///< what crosses at the start is parted before the run
  sim::GridSettings grid;
  std::filesystem::path importer;  ///< program that reads the file (import_process.hpp); empty: that of the house
  /// Instead of a file, in metres with y up; null: none. It keeps its place, and hangs by nothing that the
  /// scene does not name. Repairs of a file are made to it too.
  std::shared_ptr<const ImportedModel> given;
  /// The positions at the start, instead of a file: per vertex of what was given, or else of the simulated
  /// mesh; null: none.
  std::shared_ptr<const std::vector<sim::Vec3>> given_start_m;

  /// The file that is read as a model.
  const std::filesystem::path& model() const { return sewn.empty() ? file : sewn; }
  bool has_start() const { return !start.empty() || given_start_m; }
  /// Whether the garment is the grid.
  bool is_grid() const { return file.empty() && !given; }
};

/// Means the vertex nearest to a point.
struct NearestTo {
  sim::Vec3 point_m = {0.0, 0.0, 0.0};
};

/// Which vertices to pin. A text is a landmark or a name of pin_names() (pins.hpp); a number is a vertex of
/// the garment's file (file_mesh.hpp).
using PinSelector = std::variant<std::string, sim::Index, NearestTo>;

/// Pins that are led by a motion of their own.
struct MovingPinsInScene {
  std::vector<PinSelector> at;
  sim::RigidMotion motion;
};

/// Where the mesh of a body and its motion come from.
struct BodySource {
  std::filesystem::path file;
  std::optional<double> scale;  ///< metres per unit of the file; empty: the file's own unit, or else metres
  std::optional<ModelAxis> up;  ///< in the file's coordinates; empty: the file's own, or else y
  /// PC2 or BVH. Empty: a clip of the file, or none.
  std::filesystem::path motion;
  std::string clip;  ///< the name of an animation of the file; empty: its first; "none": it keeps its pose
  std::optional<double> frame_rate_hz;  ///< empty: what the motion says, or else 60
  double start_s = 0.0;                 ///< the time of the motion with which the run begins
  bool loop = false;                    ///< the motion repeats after its last frame, or else stays there
  int dress = 0;                   ///< frames of the scene before the run, in which the body grows into the clothes
  std::filesystem::path importer;  ///< as GarmentSource has it
};

/// All that the simulation needs to know about a scene. How it is drawn is in DrawnScene.
struct Scene {
  std::string name;  ///< as it was asked for; not a key of the file
  std::string title;
  GarmentSource garment;
  sim::MappingSettings mapping;
  sim::Material material;
  std::string fabric;  ///< the name or file that `material` and the look began as; empty: none was named
  std::optional<std::vector<PinSelector>> pins;  ///< empty: the garment hangs by its top
  double pin_width_m = 0.0;                      ///< cloth is held over this width around each of `pins`
  std::vector<MovingPinsInScene> moving_pins;    ///< besides `pins`
  RunSettings simulation;
  /// Without moving pins. Meshes of bodies are as load_bodies() left them.
  sim::Surroundings surroundings;
  std::vector<BodySource> body_sources;  ///< one for each of the bodies; those of meshes count
  /// Per body, as load_bodies() left it (app/bodies/dressing.hpp); null: it is not dressed.
  std::vector<std::shared_ptr<const Wearer>> wearers;
  std::filesystem::path checkpoint;  ///< a saved moment to begin with (run_checkpoint.hpp); empty: none
  int frames = 600;                  ///< length of the run
  /// Files that were read for it besides those that its members name: its own, and what these name in turn; not a key.
  std::vector<std::filesystem::path> files_read;

  /// Returns how many frames are simulated before frame 0, while bodies grow into the clothes.
  int dressing_frames() const;
};

/// Says why the `bounded` solver cannot promise its bound for this scene. Empty if it promises the bound, if
/// the scene has no bound, or if the scene allows exceeding it.
std::optional<std::string> beyond_promise(const Scene& scene);

/// Says why the `bounded` solver does not keep layers of this scene's cloth apart: it is too thin, or too
/// thick for its mesh. Empty if it keeps them apart or is not asked to.
std::optional<std::string> beyond_contact(const Scene& scene, const sim::Garment& garment);

/// The largest stretch that the scene's solver tries to keep, a fraction. Empty if it has none.
std::optional<double> stretch_bound(const Scene& scene);

/// The lengths that the bound holds: springs for every solver other than `bounded`.
sim::BoundKind bound_kind(const Scene& scene);

/// "bound" if the solver keeps it; "threshold" if springs are only pulled back to it.
const char* bound_word(const Scene& scene);

}  // namespace taut::app
