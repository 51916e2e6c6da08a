#include "sim/solvers/bounded/thread_choice.hpp"

namespace taut::sim::bounded {
namespace {

/// The number of frames done alone after a trial that lost. It doubles from the first value to the second
/// while trials keep losing. Larger values waste less on a busy machine and notice later that it is idle
/// again.
constexpr int fewest_between_trials = 32;
constexpr int most_between_trials = 512;

/// Returns the time, in seconds, that the chunks of others would have cost the caller, less the time it
/// waited for them.
double gained_s(double seconds, const PoolWork& work) {
  if (work.own_chunks == 0) return 0.0;
  const double others = static_cast<double>(work.others_chunks) / static_cast<double>(work.own_chunks);
  return (seconds - work.waited_s) * others - work.waited_s;
}

}  // namespace

void ThreadChoice::frame_took(double seconds, const PoolWork& work) {
  if (!is_shared()) {
    --frames_alone_;
  } else if (gained_s(seconds, work) < 0.0) {
    frames_between_trials_ = std::clamp(2 * frames_between_trials_, fewest_between_trials, most_between_trials);
    frames_alone_ = frames_between_trials_;
  } else {
    frames_between_trials_ = 0;
  }
}

}  // namespace taut::sim::bounded
