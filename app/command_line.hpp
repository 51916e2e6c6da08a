#pragma once

#include "prelude.hpp"

namespace taut::app {

/// Does what the arguments of the program ask for, the first of which is its name. Returns the exit code
/// (errors.hpp). Throws UsageError, and what the commands throw.
int run_command_line(std::span<const char* const> arguments);

}  // namespace taut::app
