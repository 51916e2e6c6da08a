#pragma once

#include <CLI/App.hpp>

#include "app/commands/options.hpp"

namespace taut::app {

/// Adds the command to the arguments of the program. Call the result after these were parsed.
std::function<int()> add_sweep(CLI::App& app);

// Options that stand for keys of the scene, written as a person would say them. Each call adds one to the
// command; `overrides` must live as long as it does.

/// `--wind SPEED[@ANGLE]`.
void add_wind(CLI::App& command, std::vector<Override>& overrides);
/// `--view NAME`: from where.
void add_side(CLI::App& command, std::vector<Override>& overrides);
/// `--resolution SIZE`, as parse_size reads it.
void add_resolution(CLI::App& command, std::vector<Override>& overrides);

/// Values of `--resolution` and `--size`, for --help.
extern const char* const size_help;
/// assets/texts/help.toml.
extern const char* const help_texts;
/// The text below the options of a command, of assets/texts/help.toml.
std::string footer_of(const std::string& command);

/// Reads a size in pixels: "1280x720", "1280,720", or a name such as "1080p" or "4K". Throws UsageError with
/// the option's name in front.
renderer::Resized parse_size(const std::string& text, const std::string& option);

}  // namespace taut::app
