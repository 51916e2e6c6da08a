#include "app/base/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include "app/base/terminal.hpp"
#include "app/base/words.hpp"

namespace taut::app {
namespace {

// Time that a stage must last before its line appears. A smaller value makes the line flicker.
constexpr std::chrono::milliseconds show_after{300};
// Time between two lines in a pipe or a file, which keep all of them.
constexpr std::chrono::seconds line_every{10};
// Time after which the line also shows the elapsed time.
constexpr std::chrono::seconds show_time_after{2};

}  // namespace

Progress::Progress(std::string what)
    : what_(std::move(what)), on_terminal_(::isatty(STDERR_FILENO) != 0), began_(Clock::now()) {
  ticker_ = std::thread([this] { keep_drawing(); });
}

Progress::~Progress() {
  {
    const std::lock_guard lock(mutex_);
    is_ended_ = true;
    clear();
  }
  ended_.notify_all();
  ticker_.join();
}

void Progress::begin(std::string stage) {
  const std::lock_guard lock(mutex_);
  stage_ = std::move(stage);
  began_ = Clock::now();
}

void Progress::show(std::string stage) {
  begin(std::move(stage));
  const std::lock_guard lock(mutex_);
  if (on_terminal_) draw();
}

void Progress::hide() {
  const std::lock_guard lock(mutex_);
  stage_.clear();
  clear();
}

void Progress::draw() {
  const auto since = Clock::now() - began_;
  std::string line = printable(what_) + ": " + printable(stage_);
  if (since >= show_time_after) {
    line += fmt::format(" ({} s)", std::chrono::duration_cast<std::chrono::seconds>(since).count());
  }
  if (!on_terminal_) {
    fmt::print(stderr, "{}\n", line);
    return;
  }
  // A line that fills the terminal would scroll it.
  fmt::print(stderr, "\r\033[K{}", cut_line(line, terminal_columns(STDERR_FILENO, line.size() + 1) - 1));
  std::fflush(stderr);
  shown_ = true;
}

void Progress::clear() {
  if (shown_) {
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    shown_ = false;
  }
}

std::string time_left(double elapsed_s, int done, int all) {
  constexpr double little_s = 1.0;
  if (done <= 0 || done >= all || elapsed_s < little_s) return "";
  const double left_s = elapsed_s / done * (all - done);
  return left_s < 100.0 ? fmt::format(", {:.0f} s left", left_s) : fmt::format(", {:.0f} min left", left_s / 60.0);
}

void Progress::keep_drawing() {
  std::unique_lock lock(mutex_);
  const std::chrono::milliseconds pause = on_terminal_ ? show_after : line_every;
  while (!ended_.wait_for(lock, pause, [this] { return is_ended_; })) {
    const bool is_due = !on_terminal_ || Clock::now() - began_ >= show_after;
    if (is_due && !stage_.empty()) draw();
  }
}

}  // namespace taut::app
