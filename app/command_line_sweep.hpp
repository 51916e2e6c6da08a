#pragma once

#include <functional>

#include "app/commands/options.hpp"

namespace CLI {
class App;
}

namespace taut::app {

/// Adds `taut sweep` with its commands. Call the result after the arguments were parsed.
std::function<Command()> add_sweep(CLI::App& app);

}  // namespace taut::app
