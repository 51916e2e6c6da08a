#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace taut::app {

/// One line on the terminal that says what a run is doing, and for how long where that is long; nothing where
/// standard error is no terminal. Functions may be called from any thread.
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// From now on it does this, such as "reading dress.fbx".
  void begin(std::string stage);
  /// As `begin`, and shows it at once: "frame 3 of 240".
  void show(std::string stage);
  /// Clears the line, for other output, until something else is begun.
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

}  // namespace taut::app
