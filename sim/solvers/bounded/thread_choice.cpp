#include "sim/solvers/bounded/thread_choice.hpp"

#include <algorithm>

namespace taut::sim::bounded {
namespace {

constexpr int fewest_between_trials = 32;
constexpr int most_between_trials = 512;
/// Of a new measurement. The machine changes within frames; what is older than some of them says little.
constexpr double trusted = 0.5;

}  // namespace

void ThreadChoice::frame_took(double seconds_per_work) {
  double& known = cost(shared_);
  known = known == 0.0 || is_trial_ ? seconds_per_work : known + trusted * (seconds_per_work - known);
  const bool other_is_known = cost(!shared_) > 0.0;
  if (is_trial_) {
    is_trial_ = false;
    const bool won = cost(shared_) < cost(!shared_);
    frames_between_trials_ =
        won ? fewest_between_trials
            : std::clamp(2 * frames_between_trials_, fewest_between_trials, most_between_trials);
    frames_to_trial_ = frames_between_trials_;
    shared_ = won ? shared_ : !shared_;
  } else if (other_is_known && cost(!shared_) < cost(shared_)) {
    shared_ = !shared_;
    frames_to_trial_ = frames_between_trials_ = fewest_between_trials;
  } else if (--frames_to_trial_ <= 0) {
    is_trial_ = true;
    shared_ = !shared_;
  }
}

}  // namespace taut::sim::bounded
