#pragma once

namespace taut::app {

/// From now on SIGINT and SIGTERM are noted instead of ending the program at once, so that a file that is
/// being written is finished. A second one ends it.
void watch_for_interruption();

/// Throws Interrupted once one of the signals came.
void throw_if_interrupted();

/// Ends the program as the signal would have, so that a shell sees what happened.
[[noreturn]] void end_by_signal(int signal);

}  // namespace taut::app
