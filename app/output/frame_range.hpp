#pragma once

#include <string>

namespace taut::app {

/// The frames `first` to `last`, both included.
struct FrameRange {
  int first = 0;
  int last = 0;

  bool contains(int frame) const { return frame >= first && frame <= last; }
  int count() const { return last - first + 1; }
};

/// The help text of --frames.
inline constexpr const char* frame_range_help =
    "A:B, A: to the last, :B from 0, last, or a number: that frame alone, but so many frames from 0 of a "
    "video "
    "or a clip (.pc2, .mdd, .glb, .pvd); frame 0 is the cloth before the first step, the last one is the "
    "scene's time.frames";

/// A number alone means so many frames of what is played, as of a video, and else the frame of that number.
enum class NumberMeans { frame, count };

/// The frames that `text` means in a run that ends with `last_frame`. Throws UsageError.
FrameRange frame_range(const std::string& text, int last_frame, NumberMeans number = NumberMeans::frame);

/// Throws UsageError where a frame comes before the one that the run begins with.
void require_begun(int start_frame, int frame);

}  // namespace taut::app
