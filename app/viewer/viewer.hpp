#pragma once

#include <future>

#include "app/caches/frame_sink.hpp"
#include "app/frame_loop.hpp"
#include "app/output/video_writer.hpp"
#include "app/runs/run_checkpoint.hpp"
#include "app/viewer/panel/panel.hpp"
#include "app/viewer/panel/user_interface.hpp"
#include "app/viewer/simulation/simulation_host.hpp"
#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// Returns the scene for saving: present settings, camera and style, with the pins and the frame that are shown.
DrawnScene kept_scene(const ViewerState& state, const ViewArea& area);

/// Returns true if running the scene from its start gives the shown state: nobody pulled and no setting changed.
bool is_pristine(const ViewerState& state);

/// Returns the shown state without a hand, for start.checkpoint of the kept scene.
RunCheckpoint kept_moment(const ViewerState& state, const DrawnScene& kept);

/// Writes the scene's pictures to a video, in real time.
class WindowRecorder {
 public:
  /// Makes a file with a name of free_name(). Throws InputError if it cannot be written.
  WindowRecorder(const std::filesystem::path& folder, const std::string& stem, int width_px, int height_px);

  /// Adds the picture as often as `elapsed_s` at rate_hz requires, which may be never. Throws InputError;
  /// std::invalid_argument if the picture has another size.
  void add(const renderer::Image& picture, double elapsed_s);
  /// Completes the video and returns a message about it.
  std::string finish();

  /// pictures per second
  static constexpr double rate_hz = 30.0;

 private:
  std::filesystem::path file_;
  std::unique_ptr<VideoWriter> video_;
  int width_px_;
  int height_px_;
  int frames_ = 0;
  double owed_s_ = 0.0;
};

/// The pointer in one frame of the window.
struct Pointer {
  glm::vec2 position_px{-1.0F};   ///< position, from the upper left corner of the garment's area
  glm::vec2 movement_px{0.0F};    ///< movement since the frame before, or since a button went down in this frame
  std::array<bool, 3> down{};     ///< buttons that are down, indexed by renderer::PointerButton
  std::array<bool, 3> pressed{};  ///< buttons that went down in this frame
  float notches = 0.0F;           ///< notches of the wheel, positive away from the user

  bool is_down(renderer::PointerButton button) const { return down[static_cast<std::size_t>(button)]; }
  bool was_pressed(renderer::PointerButton button) const { return pressed[static_cast<std::size_t>(button)]; }
};

/// The pointer in the scene: it turns, moves and zooms the view, and pulls the cloth.
class Hands {
 public:
  /// Handles one frame of the window. `is_free`: the panel does not use the pointer. Appends commands for the
  /// simulation to `commands`.
  void update(const Pointer& pointer, bool is_free, const ViewArea& area, ViewerState& state,
              std::vector<SimulationCommand>& commands);

  /// Stores the drawn snapshot. The next press selects cloth in it, even if the cloth has moved since.
  void note_seen(const SnapshotPtr& seen) { seen_ = seen; }

  /// Releases the cloth without a command. Call it when the garment has been replaced.
  void drop() { hold_.reset(); }

  /// Returns true if the pointer turns or moves the view, or holds cloth.
  bool is_busy() const { return is_turning_ || is_moving_ || hold_.has_value(); }
  /// Returns the cloth that the pointer holds; empty if it holds nothing.
  std::optional<HeldCloth> held() const;

 private:
  struct Hold {
    Grip grip;
    glm::dvec3 through{0.0};    ///< point in metres of the plane in which the hand moves
    glm::dvec3 to_vertex{0.0};  ///< vector from the picked point to the vertex, in metres
  };

  void press(const Pointer& pointer, const ViewArea& area, const ViewerState& state,
             std::vector<SimulationCommand>& commands);
  void pull(const Pointer& pointer, const ViewArea& area, const ViewerState& state,
            std::vector<SimulationCommand>& commands);

  bool is_turning_ = false;
  bool is_moving_ = false;
  std::optional<Hold> hold_;
  SnapshotPtr seen_;
};

/// Returns the point of the pointed-at garment under a pixel of its area; empty if there is none.
std::optional<PickedPoint> cloth_under(const glm::vec2& place_px, const ViewArea& area, const ViewerState& state,
                                       const Snapshot& garment);

/// Settings of a viewer at its start.
struct ViewerSettings {
  renderer::Resized size;                        ///< window size
  double scale = 1.0;                            ///< scale of the display
  std::filesystem::path keep_folder = ".";       ///< folder for screenshots, videos and saved scenes
  std::optional<sim::SolverKind> compared_with;  ///< solver of a second garment beside the first; empty: none
  bool shows_times = true;  ///< false: the picture depends only on the input, not on measured times
};

/// The viewer without window and OpenGL. It turns the input of each frame into commands for the simulation, a state to
/// draw and the triangles of the panel. Failures become messages on the screen.
class Viewer {
 public:
  /// `simulation` must outlive the viewer.
  Viewer(SimulationHost& simulation, const ViewerSettings& settings);

  /// Handles one frame of the window and returns it with its pace, for recording. Throws InputError if its pace cannot
  /// be followed, or if it points at an item that does not exist.
  SessionFrame update(SessionFrame frame);

  // State and user interface of the last frame.
  const ViewerState& state() const { return state_; }
  const UserInterface& interface() const { return interface_; }
  WindowLayout layout() const;
  /// Returns true if nothing visible changed in this frame or will change in the next one.
  bool is_still() const { return still_frames_ > 2; }

  /// Returns true if one of the last frames had input. The panel shows the effect of input one frame later.
  bool has_input() const { return frames_since_input_ <= 2; }

  /// Returns true if the user has asked to quit.
  bool is_ended() const { return is_ended_; }

  /// Returns true if take_picture() must be called, for a screenshot or a recording.
  bool wants_picture() const { return screenshot_ || recorder_; }
  bool wants_screenshot() const { return screenshot_; }
  /// Takes a picture of the scene with its legends, for the screenshot or recording.
  void take_picture(const renderer::Image& picture);
  /// Stores measured times for display. `draw_ms` and `panel_ms` belong to this frame. `simulate_ms`: CPU time of the
  /// last simulated frame. `busy_s`: CPU time of this program since the last call, divided by the number of processors.
  void note_times(double draw_ms, double panel_ms, double simulate_ms, double busy_s);
  void tell(const std::string& text, bool is_error) { app::tell(state_, text, is_error); }
  /// Completes a recording. Returns the message about it, which is also shown.
  std::optional<std::string> finish_recording();

 private:
  void take(const SessionEvent& event);
  void take(const renderer::WindowEvent& event);
  void take_key(const renderer::KeyChanged& event);
  void note_snapshot(SnapshotPtr newest);
  ViewArea area_of_one() const { return garment_area(state_, layout()); }
  Pointer pointer_over_one();
  void adopt_scene();
  renderer::Camera first_camera() const;
  void follow();
  void note_measurements();
  void choose_shown();
  SnapshotPtr within_present_bound(const SnapshotPtr& past);

  void perform(Action action);
  /// Does some work and shows its error as a message. Returns the error, or an empty text. Throws only Interrupted.
  std::string attempt(const std::function<void()>& work);
  void pause(bool paused);
  void go_on_from_shown();
  void change_wind(double by_m_per_s);
  void turn_wind(double by_rad);
  void toggle_pin();
  void show_whole_garment();
  void see_from(const ViewSide& side);
  void start_or_stop_recording();
  void save_scene();
  void export_shape();
  void load_asked();
  void take_thumbnails();
  void ask_for_scene_beside(std::ptrdiff_t by);
  void choose_fabric(const std::string& name);
  void collect_settings();
  void note_speed(std::uint64_t advances_before);
  void warn();
  void note_changes(const SessionFrame& frame);

  SimulationHost& simulation_;
  std::filesystem::path keep_folder_;
  renderer::Resized size_;
  double scale_;
  UserInterface interface_;
  ViewerState state_;
  Hands hands_;
  Pointer pointer_;
  std::set<int> keys_down_;
  std::vector<SimulationCommand> commands_;
  // Settings that the simulation has.
  ChangeSettings told_;
  double told_speed_ = 1.0;
  std::optional<sim::SolverKind> told_compared_;
  std::uint64_t told_notice_ = 0;
  glm::vec3 followed_m_{0.0F};  ///< movement of the view with the garment
  bool follows_ = false;
  std::optional<int> noted_frame_;
  // A past frame, and how it looks under the bound that was set since.
  SnapshotPtr past_;
  SnapshotPtr past_within_bound_;
  sim::SolverSettings past_bound_;

  double elapsed_s_ = 0.0;
  double busy_s_ = 0.0;  ///< all processors, since the last frame
  int pictures_ = 0;     ///< pictures since the last frame
  int still_frames_ = 0;
  int frames_since_input_ = 0;
  bool screenshot_ = false;
  bool is_ended_ = false;
  std::optional<DrawnScene> opened_;  ///< scene as it was opened; empty: it is being opened
  std::optional<WindowRecorder> recorder_;
  std::future<TextureImage> thumbnails_;  ///< valid until they are taken over
};

/// Opens a window and returns when the user closes it. Records all input to `record_to` unless it is empty. Throws
/// renderer::ContextError without a display or OpenGL, InputError if a file cannot be written, Interrupted.
void view_in_window(const SceneWithBodies& scene, const SessionStart& start, const std::filesystem::path& keep_folder,
                    const std::filesystem::path& record_to);

}  // namespace taut::app
