#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/output/run_checkpoint.hpp"
#include "app/output/video_writer.hpp"
#include "app/viewer/state/viewer_state.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

/// `folder`/STEM-N.EXTENSION with the first N that is not there yet.
std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& extension);

/// The scene as it is set now: settings, camera and looks, with the pins and the frame that are shown.
DrawnScene kept_scene(const ViewerState& state, const ViewArea& area);

/// Whether a run of the scene from its start comes to what is shown: nobody pulled, and no setting was
/// changed on the way there.
bool is_pristine(const ViewerState& state);

/// The moment that is shown, for start.checkpoint of the kept scene. No hand pulls any more.
RunCheckpoint kept_moment(const ViewerState& state, const DrawnScene& kept);

/// The camera as a section of a scene file.
std::string camera_text(const renderer::Camera& camera);

/// Makes a video or a folder of pictures of what the scene shows, in step with the clock.
class WindowRecorder {
 public:
  /// Throws InputError where it cannot begin.
  WindowRecorder(const std::filesystem::path& folder, const std::string& stem, RecordingKind kind,
                 int width_px, int height_px);

  /// As often as the time that went by needs. Throws InputError; std::invalid_argument for another size.
  void add(const renderer::Image& picture, double elapsed_s);
  /// Completes the video. Says what was written.
  std::string finish();

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

  static constexpr double rate_hz = 30.0;

 private:
  std::filesystem::path target_;  ///< the video, or the folder of pictures
  std::unique_ptr<VideoWriter> video_;
  int width_px_;
  int height_px_;
  int frames_ = 0;
  double owed_s_ = 0.0;
};

}  // namespace taut::app
