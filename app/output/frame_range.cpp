#include "app/output/frame_range.hpp"

#include <fmt/core.h>

#include <charconv>

#include "app/base/errors.hpp"

namespace taut::app {
namespace {

// Largest number of a frame.
constexpr int most_frames = 1000000;

int frame_of(const std::string& word, int last_frame, const std::string& text) {
  if (word == "last") {
    return last_frame;
  }
  int frame = -1;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, frame);
  if (error != std::errc() || stop != end || frame < 0 || frame > most_frames) {
    throw UsageError(fmt::format(
        "--frames {}: found '{}', expected a frame from 0 to {} or last, as in 0:120, 30:, :30 or last", text,
        word, most_frames));
  }
  return frame;
}

}  // namespace

FrameRange frame_range(const std::string& text, int last_frame, NumberMeans number) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    const int frame = frame_of(text, last_frame, text);
    if (number == NumberMeans::frame || text == "last") {
      return {frame, frame};
    }
    if (frame == 0) {
      throw UsageError("--frames 0: expected at least one frame of a video or a clip");
    }
    return {0, frame - 1};
  }
  const std::string first_word = text.substr(0, colon);
  const std::string last_word = text.substr(colon + 1);
  const FrameRange range = {first_word.empty() ? 0 : frame_of(first_word, last_frame, text),
                            last_word.empty() ? last_frame : frame_of(last_word, last_frame, text)};
  if (range.last < range.first) {
    throw UsageError(fmt::format("--frames {}: the last frame, {}, comes before the first, {}", text,
                                 range.last, range.first));
  }
  return range;
}

void require_begun(int start_frame, int frame) {
  if (frame < start_frame) {
    throw UsageError(fmt::format(
        "--frames: found frame {}, expected none before {}, which the run begins with", frame, start_frame));
  }
}

}  // namespace taut::app
