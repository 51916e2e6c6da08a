#pragma once

#include <functional>
#include <span>

#include "app/commands/options.hpp"

namespace CLI {
class App;
}

namespace taut::app {

/// `taut help`, also about every other command.
std::function<Command()> add_help(CLI::App& app);

/// Throws UsageError, with the commands there are, where the arguments of the program begin with no command
/// and no option.
void require_command(const CLI::App& app, std::span<const char* const> arguments);

}  // namespace taut::app
