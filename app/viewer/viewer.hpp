#pragma once

#include <optional>
#include <set>
#include <string>

#include "app/viewer/hands.hpp"
#include "app/viewer/keeping.hpp"
#include "app/viewer/panel/panel.hpp"
#include "app/viewer/panel/user_interface.hpp"
#include "app/viewer/session/session.hpp"
#include "app/viewer/simulation/simulation_host.hpp"
#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

struct ViewerSettings {
  renderer::Resized size;
  double scale = 1.0;
  std::filesystem::path keep_folder = ".";  ///< where screenshots, videos and scenes go
  bool shows_times = true;                  ///< false: what is drawn depends on the input alone
};

/// The viewer without a window: input comes in frame by frame, commands for the simulation, a state to draw
/// and the panel's triangles go out. Whatever is asked for and cannot be done becomes a message.
class Viewer {
 public:
  /// `simulation` has to outlive the viewer.
  Viewer(SimulationHost& simulation, const ViewerSettings& settings);

  /// One frame of the window. Returns it with the pace, as it has to be recorded. Throws InputError where
  /// the frame's own pace cannot be followed or it points at something that is not there.
  SessionFrame update(SessionFrame frame);

  // Of the last frame.
  const ViewerState& state() const { return state_; }
  const renderer::OverlayView& overlay() const { return interface_.overlay(); }
  /// What of the overlay belongs into a picture of the scene.
  const renderer::OverlayView& picture_overlay() const { return interface_.picture_overlay(); }
  UserInterface::Letters letters() const { return interface_.letters(); }
  WindowLayout layout() const;
  /// Nothing that is drawn has changed in this frame or is about to.
  bool is_still() const { return still_frames_ > 2; }

  /// A person does something, or did in the last frame or two: the panel shows what came of it one later.
  bool has_input() const { return frames_since_input_ <= 2; }

  /// A person has asked to end.
  bool is_ended() const { return is_ended_; }

  /// The scene's picture is wanted: for a screenshot, or a recording goes on.
  bool wants_picture() const { return screenshot_ || recorder_; }
  bool wants_screenshot() const { return screenshot_; }
  void take_picture(const renderer::Image& picture);
  /// Text for the clipboard, once.
  std::optional<std::string> take_clipboard();
  /// How long the frame took; of the processor's time, the simulation's last. Since the last call the program
  /// had all processors busy for so long. Shown in the panel.
  void note_times(double draw_ms, double panel_ms, double simulate_ms, double busy_s);
  void tell(const std::string& text, bool is_error) { app::tell(state_, text, is_error); }
  /// Completes a recording that is under way; says what came of it, as a message too.
  std::optional<std::string> finish_recording();

 private:
  void take(const SessionEvent& event);
  void take(const renderer::WindowEvent& event);
  void take_key(const renderer::KeyChanged& event);
  void note_snapshot(SnapshotPtr newest);
  void adopt_scene();
  void note_measurements();
  void choose_shown();
  SnapshotPtr within_present_bound(const SnapshotPtr& past);

  void perform(Action action);
  void perform_asked();
  void pause(bool paused);
  void go_on_from_shown();
  void change_wind(double by_m_per_s);
  void turn_wind(double by_rad);
  void toggle_pin();
  void frame_garment();
  void start_or_stop_recording();
  void save_scene();
  void load_asked();
  void load(DrawnScene scene);
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
  std::vector<Action> key_actions_;
  std::vector<SimulationCommand> commands_;
  // As the simulation was told.
  ChangeSettings told_;
  double told_speed_ = 1.0;
  std::uint64_t told_notice_ = 0;
  std::optional<int> noted_frame_;
  // A frame of the past, as it is shown under a bound that was set since.
  SnapshotPtr past_;
  SnapshotPtr past_within_bound_;
  sim::SolverSettings past_bound_;

  double elapsed_s_ = 0.0;
  double busy_s_ = 0.0;  ///< all processors, since the last frame
  int still_frames_ = 0;
  int frames_since_input_ = 0;
  bool screenshot_ = false;
  bool is_ended_ = false;
  std::optional<WindowRecorder> recorder_;
  std::string clipboard_;
};

}  // namespace taut::app
