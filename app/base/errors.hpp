#pragma once

#include <stdexcept>

namespace taut::app {

/// Exit codes of the program. A scheduler can decide by them what to run again. 0 means done.
inline constexpr int exit_bad_input = 1;
inline constexpr int exit_wrong_usage = 2;
/// A frame exceeds the bound its solver promised or cannot be made without a crossing, a frame that was to be
/// verified does not keep a promise, or a run diverged.
inline constexpr int exit_promise_broken = 3;

/// The run was stopped and can be resumed (EX_TEMPFAIL of sysexits.h).
inline constexpr int exit_can_be_resumed = 75;

/// A file or a scene cannot be used. The message names where, what was found and what was expected.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The command line cannot be used.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A frame does not keep a promise that it was to be verified for. The message names the frame and the place.
struct PromiseBroken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// SIGINT or SIGTERM asked the program to end. `signal` is its number.
struct Interrupted : std::runtime_error {
  explicit Interrupted(int number) : std::runtime_error("interrupted"), signal(number) {}
  int signal;
};

}  // namespace taut::app
