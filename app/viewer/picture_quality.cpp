#include "app/viewer/picture_quality.hpp"

#include <algorithm>

namespace taut::app {
namespace {

// The first frames of a level compile and allocate.
constexpr int ignored_frames = 2;
constexpr int frames_to_worsen = 6;
// Going up is a guess, so it is tried rarely.
constexpr int frames_to_improve = 90;
constexpr double newest_weight = 0.25;
// A single frame that another program delayed says little.
constexpr double longest_believed_ms = 1.5 * QualityControl::longest_ms;

}  // namespace

void QualityControl::note(double measured_ms) {
  const double draw_ms = std::min(measured_ms, longest_believed_ms);
  ++frames_;
  if (frames_ <= ignored_frames) {
    return;
  }
  mean_ms_ = frames_ == ignored_frames + 1 ? draw_ms : mean_ms_ + newest_weight * (draw_ms - mean_ms_);
  const bool can_worsen = level_ + 1 < picture_qualities.size();
  if (mean_ms_ > longest_ms && can_worsen && frames_ >= ignored_frames + frames_to_worsen) {
    ++level_;
    frames_ = 0;
  } else if (mean_ms_ < enough_ms && level_ > 0 && frames_ >= ignored_frames + frames_to_improve) {
    --level_;
    frames_ = 0;
  }
}

}  // namespace taut::app
