#pragma once

#include <fstream>

#include "app/scene/scene_file.hpp"
#include "renderer/context/window.hpp"

namespace taut::app {

/// Moves the pointer to a named item of the panel, so that a session written by hand does not depend on the items'
/// positions. `x` and `y`: 0 to 1 across the item.
struct PointAt {
  std::string item;
  double x = 0.5;
  double y = 0.5;

  bool operator==(const PointAt&) const = default;
};

/// Event of a session.
using SessionEvent = std::variant<renderer::WindowEvent, PointAt>;

/// Progress of the simulation in a frame of the window. A replay needs it to apply commands at the same step and to
/// point at the same cloth.
struct Pace {
  std::uint64_t advances = 0;  ///< simulated frames that had begun when the commands were posted
  std::uint64_t shown = 0;     ///< serial number of the snapshot that was shown

  bool operator==(const Pace&) const = default;
};

/// Input of one frame of the window.
struct SessionFrame {
  std::vector<SessionEvent> events;
  double elapsed_s = 1.0 / 60.0;                ///< time since the frame before
  std::optional<Pace> pace;                     ///< empty: the simulation follows `elapsed_s`
  std::optional<std::uint64_t> expected_state;  ///< hash that the newest state must have after this frame

  bool operator==(const SessionFrame&) const = default;
};

/// Start of a session: the scene and the window.
struct SessionStart {
  std::string scene;
  std::vector<Override> overrides;
  renderer::Resized size = {1280, 720};
  double scale = 1.0;  ///< scale of the display
  std::optional<sim::SolverKind> compared_with;
};

/// Input of a window from its start: recorded, written by hand or random. A session is JSON lines with one event per
/// line. The events of a frame precede its `frame` or `paced`. Keys and characters are numbers of renderer::keys and
/// Unicode:
///
///     ["taut-session", 2]
///     ["scene", "tshirt-gravity"]
///     ["set", "wind.speed=4"]
///     ["compare", "provot"]                a second garment beside the first
///     ["window", 1280, 720, 1]             width and height in pixels, content scale
///     ["move", 640, 360]                   pixels from the upper left corner
///     ["at", "wind.speed", 0.5, 0.5]       a named item of the panel, and the position on it
///     ["button", "left", true]             pressed; false: released
///     ["wheel", 0, 1]
///     ["key", 32, true]
///     ["text", 52]
///     ["drop", "/path/of/a/file"]
///     ["resize", 800, 600]
///     ["scale", 1.5]
///     ["frame", 30]                        thirty frames of the window, 1/60 s each
///     ["paced", 0.01667, 12, 13]           one recorded frame: seconds, advances, snapshot
///     ["state", 81985529216486895]         expected hash of the newest state
struct RecordedSession {
  SessionStart start;
  std::vector<SessionFrame> frames;
};

/// Reads a session. Throws InputError that names the file, the line, the value found and the value expected.
RecordedSession read_session(const std::filesystem::path& file);
/// Reads a session from text. `name` stands for the file in messages. Throws as read_session() does.
RecordedSession parse_session(const std::string& text, const std::string& name);

/// Returns the first lines of a session.
std::string session_head(const SessionStart& start);
/// Returns the lines of one frame.
std::string session_lines(const SessionFrame& frame);

/// Writes a session while it is recorded, so that it can be read even after a crash.
class SessionRecorder {
 public:
  /// Throws InputError if the file cannot be written.
  SessionRecorder(const std::filesystem::path& file, const SessionStart& start);
  /// Appends a frame. Throws InputError if it cannot be written.
  void add(const SessionFrame& frame);

 private:
  std::filesystem::path path_;
  std::ofstream file_;
};

/// Events that wait for the next frame of the window. The user interface reads pointer, buttons and keys once per
/// frame, so a click that begins and ends between two frames is split over two frames.
class InputQueue {
 public:
  void add(SessionEvent event) { waiting_.push_back(std::move(event)); }
  bool empty() const { return waiting_.empty(); }

  /// Removes and returns the events for one frame, whose order the frame need not know. Only the last of several
  /// consecutive moves is kept.
  std::vector<SessionEvent> take_frame();

 private:
  std::deque<SessionEvent> waiting_;
};

}  // namespace taut::app
