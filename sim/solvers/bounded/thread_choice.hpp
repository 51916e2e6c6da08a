#pragma once

#include <array>

namespace taut::sim::bounded {

/// Whether the threads of a team share the next frame, or the caller works alone: whichever did the same work
/// in less time lately. A helper that gets no processor in the middle of a chunk holds everybody up, so that
/// two threads on a busy machine can take twice as long as one. The way not taken is tried again for one
/// frame, after twice as many frames each time it loses, so that trying costs a few hundredths of the time at
/// most. Frames come out the same either way.
class ThreadChoice {
 public:
  bool is_shared() const { return shared_; }

  /// The frame took that long, by the clock on the wall, for each unit of its work.
  void frame_took(double seconds_per_work);

 private:
  double& cost(bool shared) { return costs_[shared ? 1 : 0]; }

  bool shared_ = true;
  bool is_trial_ = false;
  std::array<double, 2> costs_ = {0.0, 0.0};  ///< alone, shared; 0: never tried
  int frames_to_trial_ = 1;
  int frames_between_trials_ = 0;
};

}  // namespace taut::sim::bounded
