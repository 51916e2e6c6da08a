#pragma once

#include <chrono>
#include <condition_variable>
#include <ctime>
#include <mutex>
#include <thread>

#include "prelude.hpp"

namespace taut::app {

/// Measures wall-clock or CPU time since its construction. Other programs do not count as CPU time, but they can
/// lengthen it because they displace data from the caches.
class Stopwatch {
 public:
  /// `clock` is CLOCK_MONOTONIC (wall clock), CLOCK_THREAD_CPUTIME_ID (CPU time of this thread) or
  /// CLOCK_PROCESS_CPUTIME_ID (CPU time of all threads of the program).
  explicit Stopwatch(clockid_t clock = CLOCK_MONOTONIC) : clock_(clock) {}

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

/// Returns the value at position `fraction` (0 to 1) of the sorted values; between two positions the lower. The result
/// is always one of the values, as a count of steps must be. `values` must not be empty.
template <class Number> Number quantile(std::vector<Number> values, double fraction) {
  const auto rank = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

/// Returns the median of the values, which must not be empty. For an even number of values it is the mean of the two in
/// the middle; `quantile(values, 0.5)` is the lower of the two.
inline double median(std::vector<double> values) {
  std::ranges::sort(values);
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

/// A line on the terminal that says what the program is doing and, for a long stage, since when. If standard error is
/// not a terminal, a line every ten seconds. All functions may be called from any thread.
class Progress {
 public:
  /// `what` begins the line.
  explicit Progress(std::string what);
  ~Progress();

  /// Sets the text of the line, such as "reading dress.fbx". The line appears after a moment, so a short stage shows
  /// nothing.
  void begin(std::string stage);
  /// Sets the text as `begin` does and shows it at once: "frame 3 of 240".
  void show(std::string stage);
  /// Clears the line, so that other text can be printed, until the next `begin` or `show`.
  void hide();

 private:
  using Clock = std::chrono::steady_clock;

  void draw();
  void clear();
  void keep_drawing();

  std::string what_;
  bool on_terminal_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool is_ended_ = false;
  std::string stage_;  ///< empty: the line is hidden
  Clock::time_point began_;
  bool shown_ = false;
  std::thread ticker_;
};

/// Returns ", 12 s left", extrapolated from `done` of `all` units of work; empty if too little is done to tell.
std::string time_left(double elapsed_s, int done, int all);

}  // namespace taut::app
