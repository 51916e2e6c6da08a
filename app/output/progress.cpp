#include "app/output/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace taut::app {

Progress::Progress(std::string what, int last)
    : what_(std::move(what)), last_(last), on_terminal_(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) {
    std::fputs("\r\033[K", stderr);
  }
}

void Progress::show(int done, double max_stretch) {
  if (on_terminal_) {
    shown_ = true;
    fmt::print(stderr, "\r\033[K{}: frame {} of {}, stretch {:.2f} %", what_, done, last_,
               100.0 * max_stretch);
    std::fflush(stderr);
  }
}

}  // namespace taut::app
