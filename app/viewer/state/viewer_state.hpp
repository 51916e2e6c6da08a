#pragma once

#include "app/viewer/simulation/live_simulation.hpp"

namespace taut::app {

/// The part of the window that shows the scene. Its upper left corner is that of the window.
struct ViewArea {
  int width_px = 1;
  int height_px = 1;

  /// Width over height.
  float aspect() const { return static_cast<float>(width_px) / static_cast<float>(height_px); }
  bool contains(const glm::vec2& point_px) const {
    return point_px.x >= 0.0F && point_px.y >= 0.0F && point_px.x < static_cast<float>(width_px) &&
           point_px.y < static_cast<float>(height_px);
  }
};

/// A ray in the scene. `direction` has unit length.
struct Ray {
  glm::vec3 origin{0.0F};
  glm::vec3 direction{0.0F, 0.0F, -1.0F};
};

/// A camera that turns around a target point. y stays up. Points are in metres; pixels count from the upper
/// left corner of the area.
class OrbitCamera {
 public:
  OrbitCamera() = default;
  explicit OrbitCamera(const renderer::Camera& camera);

  /// Turns by a movement of the pointer. The height of the area is half a turn.
  void orbit(const glm::vec2& way_px, const ViewArea& area);
  /// Turns to this direction.
  void turn_to(float azimuth_rad, float elevation_rad);
  /// Moves the target so that points at its depth follow the pointer.
  void pan(const glm::vec2& way_px, const ViewArea& area);
  /// Moves nearer for positive notches of the wheel. The place seen at `point_px` stays there.
  void zoom(float notches, const glm::vec2& point_px, const ViewArea& area);
  /// Moves so that the whole box is visible, from the same side.
  void fit(const renderer::Box& box, const ViewArea& area);

  renderer::Camera camera() const;
  float azimuth_rad() const { return azimuth_rad_; }

  /// The ray from the eye through a pixel.
  Ray ray_through(const glm::vec2& point_px, const ViewArea& area) const;
  /// The pixel where a point is seen; empty if it is behind the eye.
  std::optional<glm::vec2> pixel_of(const glm::vec3& point, const ViewArea& area) const;

  bool operator==(const OrbitCamera&) const = default;

  /// Largest distance to the target, and largest coordinate of the target.
  static constexpr float farthest_m = 1000.0F;

 private:
  void move_target(const glm::vec3& target);

  glm::vec3 target_{0.0F};
  float distance_m_ = 3.0F;
  float azimuth_rad_ = 0.0F;    ///< 0: from +z
  float elevation_rad_ = 0.0F;  ///< above the horizon
  float vertical_fov_rad_ = 0.5F;
};

/// A point of the cloth under the pointer.
struct PickedPoint {
  sim::Index vertex = 0;  ///< corner of the triangle that is nearest to the point
  glm::dvec3 point_m{0.0};
  double distance_m = 0.0;  ///< from the eye
};

/// The nearest point where the ray meets a triangle, from either side; empty if it meets none. `positions`
/// are in metres, per vertex. It tests every triangle: ten thousand take 0.1 ms.
std::optional<PickedPoint> pick(const Ray& ray, std::span<const sim::Vec3> positions,
                                std::span<const sim::Triangle> triangles);

/// Where the ray meets the plane through the point `through` that faces the camera. Empty if it does not meet
/// it.
std::optional<glm::dvec3> drag_point(const Ray& ray, const glm::dvec3& through, const renderer::Camera& camera);

/// Tells a user who sees no cloth that it left the picture, or the range of the camera, and what to do. Empty
/// if some triangle may be visible. `positions` are in metres, per vertex.
std::string lost_cloth(std::span<const sim::Vec3> positions, std::span<const sim::Triangle> triangles,
                       const OrbitCamera& camera, const ViewArea& area);

/// The last values of a measurement, oldest first.
class RecentValues {
 public:
  void add(float value);
  void clear() { values_.clear(); }
  std::span<const float> values() const { return values_; }
  /// 0 if there is none.
  float last() const { return values_.empty() ? 0.0F : values_.back(); }

  /// Values that are kept; older ones are forgotten.
  static constexpr std::size_t most = 300;

 private:
  std::vector<float> values_;
};

/// Compares simulated time with real time, averaged over about the last second.
class RealTime {
 public:
  /// In `elapsed_s` of real time, `simulated_s` was simulated. `busy_s` is the processor time this program
  /// used, divided by the number of processors. `pictures` were shown.
  void add(double elapsed_s, double simulated_s, double busy_s, int pictures = 0);
  void forget() { *this = {}; }
  /// Simulated seconds per second of real time. Empty at the beginning.
  std::optional<double> factor() const;
  /// Fraction of all processors' time that this program used.
  double busy_share() const { return elapsed_s_ > 0.0 ? busy_s_ / elapsed_s_ : 0.0; }
  double pictures_per_s() const { return elapsed_s_ > 0.0 ? pictures_ / elapsed_s_ : 0.0; }

 private:
  double elapsed_s_ = 0.0;
  double simulated_s_ = 0.0;
  double busy_s_ = 0.0;
  double pictures_ = 0.0;
};

/// Why a simulation is slower than it should be.
enum class SlowedBy { nothing, simulation, drawing, other_programs };

/// Finds the reason. `factor` is RealTime::factor and `asked` what it should be. `simulate_ms` is the
/// processor time of a frame; `frame_ms` is what it may take at the speed asked for. If the simulation could
/// keep up, something else uses the processors: drawing if `busy_share` is high, else other programs.
SlowedBy slowed_by(double factor, double asked, double simulate_ms, double frame_ms, double busy_share);

/// A number for people that is no longer than the panel is wide, whatever the simulation does.
std::string in_little_room(double value, int decimals);

/// The stretches that the panel says beside the largest that the bound holds, which it plots: that one's 99th
/// percentile, and both of the other kind.
std::string other_stretches(const FrameRecord& record, sim::BoundKind plotted);

/// How near things come and what crosses, as the panel says it.
std::string contact_text(const sim::ContactReport& contact);

/// The measurements that the panel plots.
struct Measurements {
  RecentValues max_stretch;  ///< of the springs
  RecentValues max_surface_stretch;
  RecentValues convergence_mm;  ///< the largest |p(t) - p(t - dt)| of any vertex in a frame
  // Milliseconds of the clock; a run that has to look the same every time does not show them.
  RecentValues simulate_ms;
  RecentValues draw_ms;
  RecentValues panel_ms;
  RealTime real_time;
  double worked_ms = 0.0;  ///< processor time of the last simulated frame
  bool shows_times = true;

  /// Appends what was measured of a simulated frame.
  void add(const FrameRecord& record);
  /// Removes all values.
  void forget();
};

/// Requests of keys and buttons.
enum class Action {
  pause,
  step,
  reset,
  more_wind,
  less_wind,
  turn_wind_left,
  turn_wind_right,
  toggle_pin,
  show_whole_garment,
  see_front,
  see_side,
  see_back,
  see_three_quarters,
  screenshot,
  record,
  save_scene,
  export_shape,
  show_keys,
  close_keys,
  show_panel,
  previous_scene,
  next_scene,
  quit,
};

/// The rectangle of an item, in pixels of the window.
struct ItemPlace {
  glm::vec2 lower_px{0.0F};
  glm::vec2 upper_px{0.0F};
};

/// A built-in scene, a garment or a motion that the user can choose.
struct Choice {
  std::string name;
  std::string label;           ///< for people, such as the title of a scene; empty: the name does
  std::filesystem::path file;  ///< of an animation of the body itself: empty
};

/// The motions of a body that the user can choose.
struct MotionChoices {
  std::size_t body = 0;
  std::filesystem::path of;  ///< the body's file
  std::vector<Choice> choices;
};

/// The item of the panel under the pointer, and for how long.
struct Hovered {
  std::string name;
  double for_s = 0.0;
};

/// A line of text that disappears after some time.
struct Message {
  std::string text;
  bool is_error = false;
  double left_s = 0.0;  ///< remaining time
};

/// Cloth in the hand of the user.
struct HeldCloth {
  sim::Index vertex = 0;
  glm::dvec3 hand_m{0.0};  ///< where the hand wants the vertex, in metres
};

/// The state that the panel shows and changes. `scene` holds the settings from now on.
struct ViewerState {
  DrawnScene scene;
  OrbitCamera camera;
  bool show_normals = false;
  bool show_panel = true;
  bool show_keys = false;
  bool paused = false;
  double speed = 1.0;                            ///< simulated seconds per second; below 1 is slow motion
  std::optional<int> past_frame;                 ///< frame of the past that is shown; empty: the newest
  std::optional<sim::SolverKind> compared_with;  ///< of a second garment beside the first; empty: none

  // To be shown.
  SnapshotPtr newest;
  SnapshotPtr shown;         ///< what is drawn: `newest` or an earlier one
  bool at_compared = false;  ///< the pointer is over the second garment, or its drag began there
  std::optional<HeldCloth> held;
  Measurements measurements;
  std::vector<Choice> scenes;
  std::vector<Choice> garments;
  std::vector<Choice> fabrics;
  std::vector<std::string> thumbnails;  ///< names of scenes and garments in the order of their pictures
  MotionChoices motions;
  std::vector<Message> messages;
  std::string warning;  ///< shown while it applies; empty: none
  bool is_recording = false;

  // Requests of this frame.
  std::vector<Action> asked;
  std::optional<std::string> scene_asked;  ///< a name or a file
  std::optional<std::filesystem::path> garment_asked;
  std::optional<std::string> fabric_asked;  ///< a name; empty: the scene's own
  std::optional<Choice> motion_asked;

  std::optional<Hovered> hovered;

  /// Rectangles of the panel's items by name, for sessions written by hand and for tests.
  std::map<std::string, ItemPlace> places;
};

/// The picture's second garment; null if there is none.
const Snapshot* compared(const ViewerState& state);
/// The name of the solver that a garment is simulated by.
const char* solver_of(const Snapshot& garment);
/// The garment whose last frame took longer, which holds both back.
const char* slower_solver(const Snapshot& newest);
/// The garment below the pointer, as it is drawn.
const Snapshot& pointed_at(const ViewerState& state);

/// Shows a message for some seconds.
void tell(ViewerState& state, const std::string& text, bool is_error = false);

/// The built-in scenes with their titles, sorted by these, those about contact last. A scene that cannot be read is
/// left out.
std::vector<Choice> scene_choices();

/// The files with this ending in a folder of those that come with the program, sorted by name and by the numbers that
/// these end in.
std::vector<Choice> files_in(const std::string& folder, const std::string& ending);

/// The garments that come with the program.
inline std::vector<Choice> garment_choices() { return files_in("garments", ".obj"); }

/// The finest of the garments that is coarser than the one of this name, where names end in numbers of triangles:
/// tshirt_5280 for tshirt_10600. Null if there is none.
const Choice* coarser_than(const std::string& name, std::span<const Choice> garments);

/// Motions for the first body of the scene that has joints: those that come with the program and fit
/// it, then its own animations. None if there is no such body or it cannot be read. `known` is returned if it
/// is of that body's file.
MotionChoices motion_choices(const DrawnScene& scene, const MotionChoices& known);

/// Returns whether a body moves as the choice says.
bool is_chosen(const Choice& motion, const BodySource& source);

/// Has the body of the scene move as the choice says, over and over unless its end is too far from its begin, and the
/// scene begin anew. Returns what load_bodies() says. Throws InputError; the scene is then of no use.
std::vector<std::string> set_motion(DrawnScene& scene, std::size_t body, const Choice& motion);

/// A key, or a gesture of the pointer, and what it does.
struct KeyBinding {
  const char* label;
  const char* meaning;
  int key = 0;  ///< 0: a gesture
  std::optional<Action> action = std::nullopt;
  bool repeats = false;        ///< repeats while the key stays down
  bool needs_control = false;  ///< With Ctrl. Other keys have no function together with Ctrl.
};

/// All bindings, in the order in which the window lists them.
std::span<const KeyBinding> key_bindings();

}  // namespace taut::app
