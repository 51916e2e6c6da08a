#pragma once

#include "prelude.hpp"

namespace taut::app {

/// Runs the command that the arguments name; the first argument is the program's name. Returns the exit code
/// (errors.hpp). Throws UsageError and the exceptions of the commands.
int run_command_line(std::span<const char* const> arguments);

}  // namespace taut::app
