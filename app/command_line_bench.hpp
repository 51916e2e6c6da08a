#pragma once

#include <CLI/App.hpp>
#include <functional>

#include "app/commands/options.hpp"

namespace taut::app {

/// Adds `taut bench` to the program's arguments; the result is asked once they are read.
std::function<Command()> add_bench(CLI::App& app);

}  // namespace taut::app
