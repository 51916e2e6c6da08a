#pragma once

#include "sim/solvers/bounded/kernels/thread_pool.hpp"

namespace taut::sim::bounded {

/// Whether the threads of a pool share the next frame, or the caller works alone. A helper that loses its
/// processor in the middle of a chunk holds everybody up, so that two threads on a busy machine can take
/// twice as long as one. A frame that was shared says itself what it gained: the chunks that others did,
/// against the time the caller waited for them. Where it lost, the next frames are done alone, and more of
/// them each time a trial loses again, so that trials cost some hundredths of the time. Frames come out the
/// same either way.
class ThreadChoice {
 public:
  bool is_shared() const { return frames_alone_ == 0; }

  /// The last frame took that long by the clock on the wall; `work` is what its pool did.
  void frame_took(double seconds, const PoolWork& work);

 private:
  int frames_alone_ = 0;  ///< still to be done
  int frames_between_trials_ = 0;
};

}  // namespace taut::sim::bounded
