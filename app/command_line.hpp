#pragma once

#include "app/commands/options.hpp"

namespace taut::app {

/// Reads the arguments of the program; answers --help and --version. Throws UsageError.
Command parse_command_line(int argument_count, const char* const* arguments);

}  // namespace taut::app
