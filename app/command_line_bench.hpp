#pragma once

#include <CLI/App.hpp>
#include <functional>

#include "app/commands/options.hpp"

namespace taut::app {

/// Adds `taut bench` to the arguments of the program. Call the result after the arguments were parsed.
std::function<Command()> add_bench(CLI::App& app);

}  // namespace taut::app
