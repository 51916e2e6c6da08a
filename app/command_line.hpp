#pragma once

#include "app/commands/options.hpp"

namespace taut::app {

/// Returns what the arguments ask for. Prints the answer to --help and --version itself. Throws UsageError.
Command parse_command_line(int argument_count, const char* const* arguments);

}  // namespace taut::app
