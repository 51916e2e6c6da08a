#include "sim/solvers/bounded/thread_choice.hpp"

namespace taut::sim::bounded {
namespace {

/// Numbers of frames done alone after a trial that lost: from the first value it doubles to the second while trials
/// keep losing. Larger values waste less on a busy machine but notice later that it is idle again.
constexpr int min_trial_gap_frames = 32;
constexpr int max_trial_gap_frames = 512;

/// Returns the time in seconds that other threads' chunks would have cost the caller, minus the time it waited for
/// them.
double gained_s(double seconds, const PoolWork& work) {
  if (work.own_chunks == 0) return 0.0;
  const double others_ratio = static_cast<double>(work.others_chunks) / static_cast<double>(work.own_chunks);
  return (seconds - work.waited_s) * others_ratio - work.waited_s;
}

}  // namespace

void ThreadChoice::frame_took(double seconds, const PoolWork& work) {
  if (!is_shared()) {
    --frames_alone_;
  } else if (gained_s(seconds, work) < 0.0) {
    frames_between_trials_ = std::clamp(2 * frames_between_trials_, min_trial_gap_frames, max_trial_gap_frames);
    frames_alone_ = frames_between_trials_;
  } else {
    frames_between_trials_ = 0;
  }
}

}  // namespace taut::sim::bounded
