#pragma once

#include <fmt/core.h>

#include "prelude.hpp"

namespace taut::app {

/// Exit codes of the program, by which a scheduler can decide what to run again. 0: done.
inline constexpr int exit_bad_input = 1;
inline constexpr int exit_wrong_usage = 2;
/// A run diverged, or a frame exceeds the bound that its solver promised, cannot be made without a crossing, or failed
/// verification.
inline constexpr int exit_promise_broken = 3;

/// The run was stopped and can be resumed (EX_TEMPFAIL of sysexits.h).
inline constexpr int exit_can_be_resumed = 75;

/// An exception whose message is a format of fmt and its arguments.
template <class Base> struct Formatted : Base {
  using Base::Base;
  template <class First, class... Rest>
  Formatted(fmt::format_string<First, Rest...> format, First&& first, Rest&&... rest)
      : Base(fmt::format(format, std::forward<First>(first), std::forward<Rest>(rest)...)) {}
};

/// A file or a scene cannot be used. The message names the place, the value found and the value expected.
struct InputError : Formatted<std::runtime_error> {
  using Formatted::Formatted;
};

/// The command line cannot be used.
struct UsageError : Formatted<std::runtime_error> {
  using Formatted::Formatted;
};

/// A frame failed verification of a promise. The message names the frame and the place.
struct PromiseBroken : Formatted<std::runtime_error> {
  using Formatted::Formatted;
};

/// A model that follows the simulated cloth is stretched too much to be shown. The message says how much.
struct ModelOverstretched : Formatted<std::runtime_error> {
  using Formatted::Formatted;
};

/// SIGINT or SIGTERM asked the program to end. `signal` is its number.
struct Interrupted : std::runtime_error {
  explicit Interrupted(int number) : std::runtime_error("interrupted"), signal(number) {}
  int signal;
};

/// Returns true if the error is one of these.
template <class... Errors> bool is_any(const std::exception& error) {
  return (... || (dynamic_cast<const Errors*>(&error) != nullptr));
}

/// Records the first SIGINT or SIGTERM, so that a file being written can be finished; the second one ends the program
/// at once. Call it once, at the program's start.
void watch_for_interruption();

/// Throws Interrupted if a signal was recorded.
void throw_if_interrupted();

/// Forgets a recorded signal, so that the remaining work is finished.
void forget_interruption();

/// Ends the program with the signal's default action, so that a shell sees which signal ended it.
[[noreturn]] void end_by_signal(int signal);

}  // namespace taut::app
