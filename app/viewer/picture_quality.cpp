#include "app/viewer/picture_quality.hpp"

#include <algorithm>

namespace taut::app {
namespace {

// The first frames of a level compile and allocate.
constexpr int ignored_frames = 2;
constexpr int frames_to_worsen = 4;
// A level that was held so long has proven itself.
constexpr int proven_frames = 300;
constexpr int most_patience = 3000;
constexpr double newest_weight = 0.25;
// A single frame that another program delayed says little.
constexpr double longest_believed_ms = 1.9 * QualityControl::longest_ms;
// So slow, the next level would not do.
constexpr double far_too_long_ms = 1.6 * QualityControl::longest_ms;

}  // namespace

void QualityControl::go_to(std::size_t level) {
  level_ = std::min(level, picture_qualities.size() - 1);
  frames_ = 0;
}

void QualityControl::note(double measured_ms) {
  const double frame_ms = std::min(measured_ms, longest_believed_ms);
  ++frames_;
  if (frames_ <= ignored_frames) {
    return;
  }
  mean_ms_ = frames_ == ignored_frames + 1 ? frame_ms : mean_ms_ + newest_weight * (frame_ms - mean_ms_);
  if (is_trial_ && frames_ > proven_frames) {
    is_trial_ = false;
    patience_ = least_patience;
  }
  const bool can_worsen = level_ + 1 < picture_qualities.size();
  if (mean_ms_ > longest_ms && can_worsen && frames_ >= ignored_frames + frames_to_worsen) {
    // A trial that failed should not be seen again soon: the picture would pump.
    patience_ = is_trial_ ? std::min(2 * patience_, most_patience) : patience_;
    is_trial_ = false;
    go_to(level_ + (mean_ms_ > far_too_long_ms ? 2 : 1));
  } else if (mean_ms_ < enough_ms && level_ > 0 && frames_ >= ignored_frames + patience_) {
    is_trial_ = true;
    go_to(level_ - 1);
  }
}

}  // namespace taut::app
