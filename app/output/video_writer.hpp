#pragma once

#include <filesystem>

#include "app/base/child_process.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {

/// Returns true if the file name ends in .mp4, .gif or .webp.
bool is_video(const std::filesystem::path& file);

/// Size and rate of a video.
struct VideoSettings {
  int width_px = 0;
  int height_px = 0;
  double frame_rate_hz = 60.0;
  /// The video shows something that cannot be repeated. It is encoded with less effort, so that the program does not
  /// slow down, and an interruption does not stop it before `finish`.
  bool is_live = false;
};

/// Throws UsageError unless width and height are even for an MP4, as its colour has half the resolution.
void require_video_size(const std::filesystem::path& file, const VideoSettings& settings);

/// Makes a video with the program ffmpeg, which reads raw RGB pictures from its standard input. Equal pictures give
/// equal files. The file has a temporary name until `finish` and is removed without it.
class VideoWriter {
 public:
  /// Starts ffmpeg. Throws InputError if ffmpeg is not installed.
  VideoWriter(std::filesystem::path file, const VideoSettings& settings);
  /// Ends ffmpeg and removes an unfinished file.
  ~VideoWriter();

  /// Adds an RGB picture of the size in the settings. Throws InputError with ffmpeg's message if ffmpeg has ended.
  /// Throws Interrupted unless the video is live.
  void add(const renderer::Image& picture);

  /// Waits until all pictures are encoded, then renames the file. Throws as `add` does.
  void finish();

 private:
  [[noreturn]] void fail(const char* how, int status) const;
  void stop_if_interrupted() const;
  void send(std::span<const std::uint8_t> bytes);
  int wait_for_end();
  std::string last_message() const;

  std::filesystem::path file_;
  std::filesystem::path temporary_;
  std::size_t picture_bytes_ = 0;
  bool is_live_ = false;
  int frames_ = 0;
  Descriptor input_;     ///< our end of ffmpeg's standard input
  Descriptor messages_;  ///< ffmpeg's messages, in a memory file
  std::optional<ChildProcess> ffmpeg_;
};

}  // namespace taut::app
