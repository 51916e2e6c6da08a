#include "app/drawing/picture_quality.hpp"

namespace taut::app {
namespace {

// The first frames at a level are ignored, because they compile shaders and allocate memory.
constexpr int ignored_frames = 2;
// Consecutive slow frames before the quality is reduced: 1/3 s. Fewer would react to short loads of other programs.
constexpr int frames_to_worsen = 10;
// Mean above which the quality is reduced sooner, after frames_to_worsen_fast frames.
constexpr double max_slow_ms = 1.6 * QualityControl::max_ms;
constexpr int frames_to_worsen_fast = 4;
// Frames after which a tried level counts as fast enough.
constexpr int proven_frames = 300;
// Upper limit of trial_wait_frames_, in frames.
constexpr int max_patience = 3000;
// Weight of the newest frame in running means. A larger value reacts faster and less steadily.
constexpr double newest_weight = 0.2;
// Limit on the duration of a frame in the mean: one frame that another program delayed says little.
constexpr double max_believed_ms = 1.9 * QualityControl::max_ms;
// Fraction of max_ms below which a better level's expected time must be, to try that level.
constexpr double better_level_fraction = 0.95;
// Fractions of simulated time. Giving up more than `much` is visible as slow motion; less than `little` is not.
constexpr double max_lost_fraction = 0.05;
constexpr double negligible_lost_fraction = 0.01;
// Change of the pause after a frame, per frame.
constexpr double more_rest_ms = 2.0;
constexpr double less_rest_ms = 0.2;

}  // namespace

void PictureQuality::apply(renderer::PictureSettings& settings) const {
  settings.samples = samples;
  settings.supersampling = 1;
  settings.shadow_map_px = shadow_map_px;
  settings.shading_px = shading_px;
  settings.shadow_taps = shadow_taps;
  settings.sky_directions = sky_directions;
}

void QualityControl::go_to(std::size_t level) {
  level_ = std::min(level, picture_qualities.size() - 1);
  frames_ = 0;
  slow_frames_ = 0;
  given_up_ = 0.0;
}

// The frame rate is reduced last and restored first.
void QualityControl::note_simulation(double share_given_up) {
  given_up_ += newest_weight * (std::min(share_given_up, 1.0) - given_up_);
  if (given_up_ > max_lost_fraction && level_ + 1 == picture_qualities.size()) {
    rest_ms_ = std::min(rest_ms_ + more_rest_ms, max_rest_ms);
  } else if (given_up_ < negligible_lost_fraction) {
    rest_ms_ = std::max(rest_ms_ - less_rest_ms, 0.0);
  }
}

bool QualityControl::is_too_slow() {
  const bool is_slow = mean_ms_ > max_ms || given_up_ > max_lost_fraction;
  slow_frames_ = is_slow ? slow_frames_ + 1 : 0;
  return slow_frames_ >= (mean_ms_ > max_slow_ms ? frames_to_worsen_fast : frames_to_worsen);
}

bool QualityControl::can_afford_next_level() const {
  if (level_ == 0 || rest_ms_ > 0.0 || given_up_ > negligible_lost_fraction ||
      frames_ < ignored_frames + trial_wait_frames_) {
    return false;
  }
  const double dearer = picture_qualities[level_ - 1].cost / picture_qualities[level_].cost;
  return mean_ms_ * dearer < better_level_fraction * max_ms;
}

void QualityControl::note(double measured_ms, double given_up_ms) {
  const double frame_ms = std::min(measured_ms, max_believed_ms);
  ++frames_;
  if (frames_ <= ignored_frames) return;
  mean_ms_ = frames_ == ignored_frames + 1 ? frame_ms : mean_ms_ + newest_weight * (frame_ms - mean_ms_);
  note_simulation(given_up_ms / std::max(measured_ms, 1.0));
  if (is_trial_ && frames_ > proven_frames) {
    is_trial_ = false;
    trial_wait_frames_ = min_patience;
  }
  if (is_too_slow() && level_ + 1 < picture_qualities.size()) {
    // A failed trial must not be repeated soon, or the quality would alternate visibly.
    trial_wait_frames_ = is_trial_ ? std::min(2 * trial_wait_frames_, max_patience) : trial_wait_frames_;
    is_trial_ = false;
    go_to(level_ + (mean_ms_ > max_slow_ms ? 2 : 1));
  } else if (can_afford_next_level()) {
    is_trial_ = true;
    go_to(level_ - 1);
  }
}

}  // namespace taut::app
