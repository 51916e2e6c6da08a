#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/scene/scene_file.hpp"
#include "renderer/context/window_event.hpp"

namespace taut::app {

/// The pointer goes to a named thing of the panel: a session that is written by hand should not have to know
/// where things are. `x` and `y` are 0..1 across it.
struct PointAt {
  std::string item;
  double x = 0.5;
  double y = 0.5;

  bool operator==(const PointAt&) const = default;
};

/// The graphics driver throws its context away, as a test wants it.
struct ContextLost {
  bool operator==(const ContextLost&) const = default;
};

using SessionEvent = std::variant<renderer::WindowEvent, PointAt, ContextLost>;

/// How far the simulation was when a frame of the window was made; without it a replay could hand a command
/// to another step, or aim at another cloth.
struct Pace {
  std::uint64_t advances = 0;  ///< simulated frames begun when the frame's commands were handed over
  std::uint64_t shown = 0;     ///< serial of the snapshot the frame showed

  bool operator==(const Pace&) const = default;
};

/// What went into one frame of the window.
struct SessionFrame {
  std::vector<SessionEvent> events;
  double elapsed_s = 1.0 / 60.0;                ///< since the frame before
  std::optional<Pace> pace;                     ///< none: the simulation follows `elapsed_s`
  std::optional<std::uint64_t> expected_state;  ///< hash of the newest state after this frame

  bool operator==(const SessionFrame&) const = default;
};

/// What a session begins with.
struct SessionStart {
  std::string scene;
  std::vector<Override> overrides;
  renderer::Resized size = {1280, 720};
  double scale = 1.0;
};

/// Input to a window from its start: recorded, written by hand or made at random. A text file, one event a
/// line; the events of a frame stand before its `frame` or `paced`:
///
///     taut-session 1
///     scene tshirt-gravity
///     set wind.speed=4
///     window 1280 720 1              width and height in pixels, content scale
///     move 640 360                   pixels from the upper left corner
///     at wind.speed 0.5 0.5          a named thing of the panel, and where on it
///     button left down
///     wheel 0 1
///     key space down
///     text U+0034
///     drop /path/of/a/file
///     resize 800 600
///     scale 1.5
///     lose-context
///     frame 30                       thirty frames of the window, 1/60 s each
///     paced 0.01667 12 13            one frame as it was recorded: seconds, advances, snapshot
///     state 0123456789abcdef         what the hash of the newest state has to be
struct Session {
  SessionStart start;
  std::vector<SessionFrame> frames;
};

/// Throws InputError naming the file, the line, what was found and what is expected.
Session read_session(const std::filesystem::path& file);
/// As read_session; `name` stands for the file in messages.
Session parse_session(const std::string& text, const std::string& name);

std::string session_head(const SessionStart& start);
std::string session_lines(const SessionFrame& frame);

/// Writes a session while it goes on, so that it is there even after a crash.
class SessionRecorder {
 public:
  /// Throws InputError where the file cannot be written.
  SessionRecorder(const std::filesystem::path& file, const SessionStart& start);
  void add(const SessionFrame& frame);

 private:
  std::filesystem::path path_;
  std::ofstream file_;
};

}  // namespace taut::app
