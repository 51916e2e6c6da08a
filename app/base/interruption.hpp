#pragma once

#include "prelude.hpp"

namespace taut::app {

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
