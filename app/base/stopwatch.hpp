#pragma once

#include <chrono>
#include <ctime>

#include "prelude.hpp"

namespace taut::app {

/// Measures wall time from its construction.
class Stopwatch {
 public:
  /// Milliseconds since construction.
  double elapsed_ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Measures processor time from its construction. Other programs do not add to it directly. They can still
/// lengthen it, because they displace data from the caches.
class ProcessorStopwatch {
 public:
  /// `clock` is CLOCK_THREAD_CPUTIME_ID for this thread, or CLOCK_PROCESS_CPUTIME_ID for all threads of the
  /// program.
  explicit ProcessorStopwatch(clockid_t clock = CLOCK_THREAD_CPUTIME_ID) : clock_(clock) {}

  double elapsed_ms() const { return now_ms() - start_ms_; }

 private:
  double now_ms() const {
    timespec time{};
    ::clock_gettime(clock_, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  }

  clockid_t clock_;
  double start_ms_ = now_ms();
};

}  // namespace taut::app
