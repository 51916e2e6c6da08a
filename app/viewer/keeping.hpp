#pragma once

#include "app/caches/frame_sink.hpp"
#include "app/frame_loop.hpp"
#include "app/output/run_checkpoint.hpp"
#include "app/output/video_writer.hpp"
#include "app/viewer/simulation/simulation_host.hpp"
#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// The scene as it is set now, for saving: settings, camera and look, with the pins and the frame that are
/// shown.
DrawnScene kept_scene(const ViewerState& state, const ViewArea& area);

/// Whether running the scene from its start gives what is shown. That is so if nobody pulled and no setting
/// changed.
bool is_pristine(const ViewerState& state);

/// The state that is shown, for start.checkpoint of the kept scene. It holds no hand.
RunCheckpoint kept_moment(const ViewerState& state, const DrawnScene& kept);

/// Writes what the scene shows to a video, in real time.
class WindowRecorder {
 public:
  /// The file's name is that of free_name(). Throws InputError if it cannot be written.
  WindowRecorder(const std::filesystem::path& folder, const std::string& stem, int width_px, int height_px);

  /// Adds the picture as often as `elapsed_s` at rate_hz requires; that may be never. Throws InputError;
  /// std::invalid_argument if the picture has another size.
  void add(const renderer::Image& picture, double elapsed_s);
  /// Completes the video. Returns what was written, for people.
  std::string finish();

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

  /// Pictures per second.
  static constexpr double rate_hz = 30.0;

 private:
  std::filesystem::path file_;
  std::unique_ptr<VideoWriter> video_;
  int width_px_;
  int height_px_;
  int frames_ = 0;
  double owed_s_ = 0.0;
};

}  // namespace taut::app
