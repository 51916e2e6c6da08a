#pragma once

#include "app/drawing/picking.hpp"
#include "app/viewer/simulation/live_simulation.hpp"

namespace taut::app {

/// The part of the window that shows the scene, at the window's upper left corner.
struct ViewArea {
  int width_px = 1;
  int height_px = 1;

  /// Returns width over height.
  float aspect() const { return static_cast<float>(width_px) / static_cast<float>(height_px); }
  bool contains(const glm::vec2& point_px) const {
    return point_px.x >= 0.0F && point_px.y >= 0.0F && point_px.x < static_cast<float>(width_px) &&
           point_px.y < static_cast<float>(height_px);
  }
};

/// A camera that turns around a target point, with y up. Points are in metres; pixels count from the upper left corner
/// of the area.
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
  /// Moves nearer for positive notches of the wheel. The point seen at `point_px` stays there.
  void zoom(float notches, const glm::vec2& point_px, const ViewArea& area);
  /// Moves eye and target.
  void move(const glm::vec3& by_m) { move_target(target_ + by_m); }
  /// Moves so that the whole box is visible, without turning.
  void fit(const renderer::Box& box, const ViewArea& area);

  renderer::Camera camera() const;
  float azimuth_rad() const { return azimuth_rad_; }

  /// Returns the ray from the eye through a pixel.
  Ray ray_through(const glm::vec2& point_px, const ViewArea& area) const;
  /// Returns the pixel of a point; empty if the point is behind the eye.
  std::optional<glm::vec2> project_to_pixel(const glm::vec3& point, const ViewArea& area) const;

  bool operator==(const OrbitCamera&) const = default;

  /// Largest distance to the target, and largest coordinate of the target.
  static constexpr float max_distance_m = 1000.0F;

 private:
  void move_target(const glm::vec3& target);

  glm::vec3 target_{0.0F};
  float distance_m_ = 3.0F;
  float azimuth_rad_ = 0.0F;    ///< 0: view from +z
  float elevation_rad_ = 0.0F;  ///< angle above the horizon
  float vertical_fov_rad_ = 0.5F;
};

/// Returns the intersection of the ray with the plane through the point `through` that faces the camera; empty if there
/// is none.
std::optional<glm::dvec3> drag_point(const Ray& ray, const glm::dvec3& through, const renderer::Camera& camera);

/// Returns a message that the cloth has left the picture or the camera's range, with a remedy. Empty if a triangle may
/// be visible. `positions`: metres, per vertex.
std::string lost_cloth(std::span<const sim::Vec3> positions, std::span<const sim::Triangle> triangles,
                       const OrbitCamera& camera, const ViewArea& area);

/// The last values of a measurement, oldest first.
class RecentValues {
 public:
  void add(float value);
  void clear() { values_.clear(); }
  std::span<const float> values() const { return values_; }
  /// Returns the newest value, or 0 if there is none.
  float last() const { return values_.empty() ? 0.0F : values_.back(); }

  /// Maximum number of values; older ones are dropped.
  static constexpr std::size_t max_count = 300;

 private:
  std::vector<float> values_;
};

/// Compares simulated time with real time, averaged over about the last second.
class RealTime {
 public:
  /// Adds a period: `elapsed_s` of real time, `simulated_s` of simulated time, `pictures` shown. `busy_s`: CPU time of
  /// this program divided by the number of processors.
  void add(double elapsed_s, double simulated_s, double busy_s, int pictures = 0);
  void forget() { *this = {}; }
  /// Returns simulated seconds per second of real time; empty at the beginning.
  std::optional<double> factor() const;
  /// Returns the fraction of all processors' time that this program used.
  double busy_share() const { return elapsed_s_ > 0.0 ? busy_s_ / elapsed_s_ : 0.0; }
  double pictures_per_s() const { return elapsed_s_ > 0.0 ? pictures_ / elapsed_s_ : 0.0; }

 private:
  double elapsed_s_ = 0.0;
  double simulated_s_ = 0.0;
  double busy_s_ = 0.0;
  double pictures_ = 0.0;
};

/// Reason why a simulation is slower than it should be.
enum class SlowedBy { nothing, simulation, drawing, other_programs };

/// Finds the reason. `factor`: RealTime::factor, and `asked` its target. `simulate_ms`: CPU time of a frame, and
/// `frame_ms` its target. If the simulation is fast enough, something else uses the processors: drawing if `busy_share`
/// is high, else other programs.
SlowedBy find_slowdown(double factor, double asked, double simulate_ms, double frame_ms, double busy_share);

/// Returns a number as a text that fits into the panel for any value.
std::string short_number(double value, int decimals);

/// Returns the stretches that the panel shows in addition to the plotted maximum of the bounded kind, in two lines:
/// the maximum of the other kind, and the 99th percentiles of both.
std::string other_stretches(const FrameRecord& record, sim::BoundKind plotted);

/// Returns the panel's text about the smallest distance and crossings.
std::string contact_text(const sim::ContactReport& contact);

/// Measurements that the panel plots.
struct Measurements {
  RecentValues max_stretch;  ///< largest stretch of the springs
  RecentValues max_surface_stretch;
  RecentValues convergence_mm;  ///< largest |p(t) - p(t - dt)| of any vertex in a frame
  // Wall-clock times in ms. They are hidden in runs that must always look the same.
  RecentValues simulate_ms;
  RecentValues draw_ms;
  RecentValues panel_ms;
  RealTime real_time;
  double worked_ms = 0.0;  ///< smoothed CPU time of a simulated frame
  bool shows_times = true;

  /// Appends the measurements of a simulated frame.
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

/// Rectangle of an item, in pixels of the window.
struct ItemPlace {
  glm::vec2 lower_px{0.0F};
  glm::vec2 upper_px{0.0F};
};

/// A built-in scene, a garment or a motion that the user can choose.
struct Choice {
  std::string name;
  std::string label;           ///< text to show, such as the title of a scene; empty: `name`
  std::filesystem::path file;  ///< empty: an animation in the body's own file
};

/// Motions of a body that the user can choose.
struct MotionChoices {
  std::size_t body = 0;
  std::filesystem::path of;  ///< file of the body
  std::vector<Choice> choices;
};

/// Item of the panel under the pointer, and the time that the pointer has been there.
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

/// Cloth in the user's hand.
struct HeldCloth {
  sim::Index vertex = 0;
  glm::dvec3 hand_m{0.0};  ///< target position of the vertex in metres
};

/// State that the panel shows and changes. `scene` has the present settings.
struct ViewerState {
  DrawnScene scene;
  OrbitCamera camera;
  bool show_normals = false;
  bool show_panel = true;
  bool show_keys = false;
  bool paused = false;
  double speed = 1.0;                            ///< simulated seconds per second; below 1 is slow motion
  std::optional<int> past_frame;                 ///< past frame that is shown; empty: the newest
  std::optional<sim::SolverKind> compared_with;  ///< solver of a second garment beside the first; empty: none

  // Data to show.
  SnapshotPtr newest;
  SnapshotPtr shown;            ///< drawn snapshot: `newest` or an earlier one
  bool is_over_second = false;  ///< the pointer is over the second garment, or its drag began there
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
  std::optional<std::string> scene_asked;  ///< name or file
  std::optional<std::filesystem::path> garment_asked;
  std::optional<std::string> fabric_asked;  ///< name; empty: the scene's own fabric
  std::optional<Choice> motion_asked;

  std::optional<Hovered> hovered;

  /// Rectangles of the panel's items by name, for sessions written by hand and for tests.
  std::map<std::string, ItemPlace> places;
};

/// Returns how far a camera that follows the garment has moved with it; 0 if the scene's does not.
glm::vec3 followed_m(const ViewerState& state, const Snapshot& garment);
/// Returns the camera without what it has followed, for GarmentPainter and saved scenes.
renderer::Camera camera_at_rest(const ViewerState& state, const Snapshot& garment);
/// Returns the picture's second garment; null if there is none.
const Snapshot* compared_garment(const ViewerState& state);
/// Returns the name of a garment's solver.
const char* solver_name(const Snapshot& garment);
/// Returns the name of the solver whose last frame took longer.
const char* slower_solver(const Snapshot& newest);
/// Returns the drawn garment under the pointer.
const Snapshot& pointed_at(const ViewerState& state);

/// Shows a message for some seconds.
void tell(ViewerState& state, const std::string& text, bool is_error = false);

/// Returns the readable built-in scenes with their titles, sorted by title, those with contact last.
std::vector<Choice> scene_choices();

/// Returns the built-in files with this extension in a folder, sorted by name and by the number at the end of the name.
std::vector<Choice> files_in(const std::string& folder, const std::string& ending);

/// Returns the built-in garments.
inline std::vector<Choice> garment_choices() { return files_in("garments", ".obj"); }

/// Returns motions for the scene's first body with joints: the built-in ones that fit it, then its own animations.
/// Empty if there is no such body or it cannot be read. Returns `known` if it belongs to that body's file.
MotionChoices motion_choices(const DrawnScene& scene, const MotionChoices& known);

/// Returns true if the body has this motion.
bool is_chosen(const Choice& motion, const BodySource& source);

/// Gives the body of the scene this motion, which repeats unless its end is too far from its start. The scene starts
/// again. Throws InputError; the scene is then unusable.
void set_motion(std::size_t body, const Choice& motion, SceneWithBodies& shown);

/// A key, or a gesture of the pointer, with its effect.
struct KeyBinding {
  const char* label;
  const char* meaning;
  int key = 0;  ///< 0: a gesture of the pointer
  std::optional<Action> action = std::nullopt;
  bool repeats = false;        ///< repeats while the key stays down
  bool needs_control = false;  ///< true: only with Ctrl; other keys have no effect together with Ctrl
};

/// Returns all bindings, in the order in which the window lists them.
std::span<const KeyBinding> key_bindings();

}  // namespace taut::app
