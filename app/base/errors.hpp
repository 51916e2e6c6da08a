#pragma once

#include <stdexcept>

namespace taut::app {

/// How the program ends, so that a scheduler can tell what to try again. 0: done.
inline constexpr int exit_bad_input = 1;
inline constexpr int exit_wrong_usage = 2;
inline constexpr int exit_promise_broken =
    3;  ///< a frame exceeds what its solver promised, or a run diverged

inline constexpr int exit_can_be_resumed =
    75;  ///< stopped, and saved: sysexits.h calls it a temporary failure

/// A file or a scene is not as it has to be.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The command line is not as it has to be.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The person at the terminal, or the system, asked the program to end.
struct Interrupted : std::runtime_error {
  explicit Interrupted(int number) : std::runtime_error("interrupted"), signal(number) {}
  int signal;
};

}  // namespace taut::app
