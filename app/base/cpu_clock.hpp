#pragma once

#include <ctime>

namespace taut::app {

/// Processor time of all threads of the process since it was made: other programs do not count, but what
/// they throw out of the caches does.
class CpuClock {
 public:
  double elapsed_ms() const { return now_ms() - start_ms_; }

 private:
  static double now_ms() {
    timespec time = {};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  }

  double start_ms_ = now_ms();
};

}  // namespace taut::app
