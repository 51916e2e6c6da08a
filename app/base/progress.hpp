#pragma once

#include <chrono>
#include <condition_variable>
#include <ctime>
#include <mutex>
#include <thread>

#include "prelude.hpp"

namespace taut::app {

/// Measures time from its construction: the wall's, or a processor's. Other programs do not add to a processor's
/// directly. They can still lengthen it, because they displace data from the caches.
class Stopwatch {
 public:
  /// `clock` is CLOCK_MONOTONIC for the wall's, CLOCK_THREAD_CPUTIME_ID for the processor's time of this thread, or
  /// CLOCK_PROCESS_CPUTIME_ID for that of all threads of the program.
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

/// The value at place `fraction` (0 to 1) of the sorted values, between two places the lower. It is always
/// one of the values, as a count of steps must be. `values` must not be empty.
template <class Number> Number ranked(std::vector<Number> values, double fraction) {
  const auto rank = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

/// The median of the values, which must not be empty. For an even number of values it is the mean of the two
/// in the middle. `ranked(values, 0.5)` is the lower of the two.
inline double median(std::vector<double> values) {
  std::ranges::sort(values);
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

/// One line on the terminal that says what the program is doing. If that takes long, it also says for how
/// long. Prints nothing if standard error is not a terminal. All functions may be called from any thread.
class Progress {
 public:
  /// `what` stands at the beginning of the line.
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Sets the text of the line, such as "reading dress.fbx". It appears after a moment, so short work shows
  /// nothing.
  void begin(std::string stage);
  /// As `begin`, but the line appears at once: "frame 3 of 240".
  void show(std::string stage);
  /// Clears the line, so that other text can be printed. It returns with the next `begin` or `show`.
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
  std::string stage_;  ///< empty: nothing is shown
  Clock::time_point began_;
  bool shown_ = false;
  std::thread ticker_;
};

/// Returns ", 12 s left", by what was done of all of it in this time; empty if that says too little.
std::string time_left(double elapsed_s, int done, int all);

}  // namespace taut::app
