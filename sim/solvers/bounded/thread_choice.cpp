#include "sim/solvers/bounded/thread_choice.hpp"

#include <algorithm>

namespace taut::sim::bounded {
namespace {

/// Frames done alone after a trial that lost, doubled from the first to the second as trials go on losing.
/// More wastes less on a busy machine and notices later that it is idle again.
constexpr int fewest_between_trials = 32;
constexpr int most_between_trials = 512;

/// What the chunks of others would have cost the caller, less what it waited for them.
double gained_s(double seconds, const PoolWork& work) {
  if (work.own_chunks == 0) {
    return 0.0;
  }
  const double others = static_cast<double>(work.others_chunks) / static_cast<double>(work.own_chunks);
  return (seconds - work.waited_s) * others - work.waited_s;
}

}  // namespace

void ThreadChoice::frame_took(double seconds, const PoolWork& work) {
  if (!is_shared()) {
    --frames_alone_;
  } else if (gained_s(seconds, work) < 0.0) {
    frames_between_trials_ =
        std::clamp(2 * frames_between_trials_, fewest_between_trials, most_between_trials);
    frames_alone_ = frames_between_trials_;
  } else {
    frames_between_trials_ = 0;
  }
}

}  // namespace taut::sim::bounded
