#pragma once

#include "prelude.hpp"
#include "sim/solvers/bounded/kernels/thread_pool.hpp"

namespace taut::sim::bounded {

/// Decides, frame by frame, whether the threads of a pool share the work or the caller works alone. A thread that loses
/// its processor in the middle of a chunk makes all others wait, so on a busy machine two threads can take twice as
/// long as one. Shared frames are judged: the chunks of other threads against the time the caller waited for them. If
/// sharing lost time, the next frames are done alone, and more of them after each further loss, so that trials cost a
/// few hundredths of the time. Results are the same either way.
class ThreadChoice {
 public:
  bool is_shared() const { return frames_alone_ == 0; }

  /// Reports the last frame: its duration in wall-clock seconds and the work of its pool.
  void frame_took(double seconds, const PoolWork& work);

 private:
  int frames_alone_ = 0;  ///< frames still to be done alone
  int frames_between_trials_ = 0;
};

}  // namespace taut::sim::bounded
