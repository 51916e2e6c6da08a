#pragma once

#include <functional>
#include <span>

#include "app/commands/options.hpp"

namespace CLI {
class App;
}

namespace taut::app {

/// Adds `taut help`, which explains every command. Call the result after the arguments were parsed.
std::function<Command()> add_help(CLI::App& app);

/// Throws UsageError, with a list of the commands, if the arguments begin neither with a command nor with an
/// option.
void require_command(const CLI::App& app, std::span<const char* const> arguments);

}  // namespace taut::app
