#pragma once

#include <filesystem>

#include "prelude.hpp"

namespace taut::app {

/// Largest frame number.
inline constexpr int max_frame = 1'000'000;

/// A pattern for file names that contain the number of a frame: "frames/frame_{frame:04}.png".
class OutputPattern {
 public:
  /// Throws UsageError unless the text ends in `extension` (such as ".png") and has at most one field. A field is
  /// {frame} or {frame:0N}, where N is the number of digits.
  OutputPattern(const std::string& text, const std::string& extension);

  /// Throws UsageError if there are several frames but the pattern has no field.
  void require_distinct_names(std::size_t frame_count) const;

  /// Returns true if the name depends on the frame.
  bool has_field() const { return has_field_; }

  /// Returns the file name for a frame.
  std::filesystem::path path_of(int frame) const;

 private:
  std::string before_;
  std::string after_;
  bool has_field_ = false;
  int width_ = 0;
  std::string text_;
};

/// Returns "wrote a.png", or the first and the last name of several frames.
std::string describe_written(const OutputPattern& pattern, std::span<const int> frames);

/// Frames from `first` to `last`, both included.
struct FrameRange {
  int first = 0;
  int last = 0;

  bool contains(int frame) const { return frame >= first && frame <= last; }
  int count() const { return last - first + 1; }
};

/// Meaning of a single number on the command line: a frame's number, or for a video the count of frames.
enum class NumberMeans { frame, count };

/// Returns the range of frames that `text` gives, in a run that ends with `last_frame`. Throws UsageError.
FrameRange frame_range(const std::string& text, int last_frame, NumberMeans number = NumberMeans::frame);

/// Throws UsageError if `frame` comes before the run's start frame.
void require_not_before_start(int start_frame, int frame);

}  // namespace taut::app
