#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "prelude.hpp"

namespace taut::app {

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
