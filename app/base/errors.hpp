#pragma once

#include <fmt/core.h>

#include "prelude.hpp"

namespace taut::app {

/// Exit codes of the program. A scheduler can decide by them what to run again. 0 means done.
inline constexpr int exit_bad_input = 1;
inline constexpr int exit_wrong_usage = 2;
/// A frame exceeds the bound its solver promised or cannot be made without a crossing, a frame that was to be
/// verified does not keep a promise, or a run diverged.
inline constexpr int exit_promise_broken = 3;

/// The run was stopped and can be resumed (EX_TEMPFAIL of sysexits.h).
inline constexpr int exit_can_be_resumed = 75;

/// An error whose message may be formatted by fmt: a format and its arguments.
template <class Base> struct Formatted : Base {
  using Base::Base;
  template <class First, class... Rest>
  Formatted(fmt::format_string<First, Rest...> format, First&& first, Rest&&... rest)
      : Base(fmt::format(format, std::forward<First>(first), std::forward<Rest>(rest)...)) {}
};

/// A file or a scene cannot be used. The message names where, what was found and what was expected.
struct InputError : Formatted<std::runtime_error> {
  using Formatted::Formatted;
};

/// The command line cannot be used.
struct UsageError : Formatted<std::runtime_error> {
  using Formatted::Formatted;
};

/// A frame does not keep a promise that it was to be verified for. The message names the frame and the place.
struct PromiseBroken : Formatted<std::runtime_error> {
  using Formatted::Formatted;
};

/// SIGINT or SIGTERM asked the program to end. `signal` is its number.
struct Interrupted : std::runtime_error {
  explicit Interrupted(int number) : std::runtime_error("interrupted"), signal(number) {}
  int signal;
};

/// Call once at the start. From then on the first SIGINT or SIGTERM is only noted, so that a file being
/// written can be finished. The second one ends the program at once.
void watch_for_interruption();

/// Throws Interrupted if a signal has been noted.
void throw_if_interrupted();

/// Takes a noted signal as answered: the work that is left is finished.
void forget_interruption();

/// Ends the program with the signal's default action, so that a shell sees which signal ended it.
[[noreturn]] void end_by_signal(int signal);

}  // namespace taut::app
