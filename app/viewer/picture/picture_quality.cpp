#include "app/viewer/picture/picture_quality.hpp"

namespace taut::app {
namespace {

// The first frames at a level are ignored, because they compile shaders and allocate memory.
constexpr int ignored_frames = 2;
// Slow frames in a row before the quality is reduced: 1/3 s. Fewer would react to short loads of other
// programs.
constexpr int frames_to_worsen = 10;
// With a mean above this the quality is reduced sooner, after frames_to_worsen_fast frames.
constexpr double far_too_long_ms = 1.6 * QualityControl::longest_ms;
constexpr int frames_to_worsen_fast = 4;
// A level that was kept for this many frames has proven itself.
constexpr int proven_frames = 300;
// Upper limit of patience_, in frames.
constexpr int most_patience = 3000;
// Weight of the newest frame in running means. A larger value reacts faster and less steadily.
constexpr double newest_weight = 0.2;
// A longer frame counts as this long, because one frame that another program delayed says little.
constexpr double longest_believed_ms = 1.9 * QualityControl::longest_ms;
// A better level is tried if its expected time is below this fraction of longest_ms.
constexpr double room = 0.95;
// Fractions of simulated time. Giving up more than `much` is visible as slow motion; less than `little` does
// not matter.
constexpr double much_given_up = 0.05;
constexpr double little_given_up = 0.01;
// How much the pause after a frame grows or shrinks in one frame.
constexpr double more_rest_ms = 2.0;
constexpr double less_rest_ms = 0.2;

}  // namespace

void QualityControl::go_to(std::size_t level) {
  level_ = std::min(level, picture_qualities.size() - 1);
  frames_ = 0;
  slow_frames_ = 0;
  given_up_ = 0.0;
}

// The picture's rate is the last thing to give way, and the first to come back.
void QualityControl::note_simulation(double share_given_up) {
  given_up_ += newest_weight * (std::min(share_given_up, 1.0) - given_up_);
  if (given_up_ > much_given_up && level_ + 1 == picture_qualities.size()) {
    rest_ms_ = std::min(rest_ms_ + more_rest_ms, most_rest_ms);
  } else if (given_up_ < little_given_up) {
    rest_ms_ = std::max(rest_ms_ - less_rest_ms, 0.0);
  }
}

bool QualityControl::is_too_slow() {
  const bool is_slow = mean_ms_ > longest_ms || given_up_ > much_given_up;
  slow_frames_ = is_slow ? slow_frames_ + 1 : 0;
  return slow_frames_ >= (mean_ms_ > far_too_long_ms ? frames_to_worsen_fast : frames_to_worsen);
}

bool QualityControl::has_time_for_better() const {
  if (level_ == 0 || rest_ms_ > 0.0 || given_up_ > little_given_up || frames_ < ignored_frames + patience_) {
    return false;
  }
  const double dearer = picture_qualities[level_ - 1].cost / picture_qualities[level_].cost;
  return mean_ms_ * dearer < room * longest_ms;
}

void QualityControl::note(double measured_ms, double given_up_ms) {
  const double frame_ms = std::min(measured_ms, longest_believed_ms);
  ++frames_;
  if (frames_ <= ignored_frames) return;
  mean_ms_ = frames_ == ignored_frames + 1 ? frame_ms : mean_ms_ + newest_weight * (frame_ms - mean_ms_);
  note_simulation(given_up_ms / std::max(measured_ms, 1.0));
  if (is_trial_ && frames_ > proven_frames) {
    is_trial_ = false;
    patience_ = least_patience;
  }
  if (is_too_slow() && level_ + 1 < picture_qualities.size()) {
    // A trial that failed should not be seen again soon: the picture would pump.
    patience_ = is_trial_ ? std::min(2 * patience_, most_patience) : patience_;
    is_trial_ = false;
    go_to(level_ + (mean_ms_ > far_too_long_ms ? 2 : 1));
  } else if (has_time_for_better()) {
    is_trial_ = true;
    go_to(level_ - 1);
  }
}

}  // namespace taut::app
