#pragma once

#include <stdexcept>

namespace taut::app {

/// A file, a scene or a run is not as it has to be; exit code 1.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The command line is not as it has to be; exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The person at the terminal, or the system, asked the program to end.
struct Interrupted : std::runtime_error {
  explicit Interrupted(int number) : std::runtime_error("interrupted"), signal(number) {}
  int signal;
};

}  // namespace taut::app
