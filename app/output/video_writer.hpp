#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "renderer/page/image.hpp"

namespace taut::app {

/// Whether a file of this name is a video: .mp4 or .gif.
bool is_video(const std::filesystem::path& file);

struct VideoSettings {
  int width_px = 0;
  int height_px = 0;
  double frame_rate_hz = 60.0;
  /// Of something that happens once and cannot be drawn again: encoded with less effort, so that it goes on
  /// undisturbed, and an interruption does not stop it before `finish`.
  bool is_live = false;
};

/// Throws UsageError where the kind of video cannot have this size: H.264 with halved colour resolution needs
/// even numbers.
void require_video_size(const std::filesystem::path& file, const VideoSettings& settings);

/// Pictures become a video file through the program ffmpeg, to which they are handed as raw RGB. The same
/// pictures give the same file. It is written under a temporary name; unless `finish` is reached nothing is
/// left of it.
class VideoWriter {
 public:
  /// Starts ffmpeg. Throws InputError where there is none.
  VideoWriter(std::filesystem::path file, const VideoSettings& settings);
  /// Ends ffmpeg and removes what is not finished.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// RGB of the size in the settings. A GIF leaves out as many as it takes to show at most 50 in a second.
  /// Throws InputError with ffmpeg's own words when it has stopped, and
  /// Interrupted unless the video is live.
  void add(const renderer::Image& picture);

  /// Waits until all is encoded and gives the file its name. Throws as `add` does.
  void finish();

  /// In the file, once it is finished.
  int frames() const { return frames_; }

 private:
  [[noreturn]] void fail_stopped();
  void stop_if_interrupted() const;
  void send(std::span<const std::uint8_t> bytes);
  int wait_for_end();
  void close_input();
  std::string last_words() const;

  std::filesystem::path file_;
  std::filesystem::path temporary_;
  std::size_t picture_bytes_ = 0;
  bool is_live_ = false;
  int pictures_for_a_frame_ = 1;
  int pictures_ = 0;
  int frames_ = 0;
  pid_t process_ = -1;  ///< -1: ended
  int input_ = -1;      ///< our end of ffmpeg's standard input
  int messages_ = -1;   ///< what ffmpeg writes to standard error, a file in memory
};

}  // namespace taut::app
