#pragma once

#include <CLI/CLI.hpp>

#include "app/drawing/drawn_scene.hpp"

namespace taut::app {

// These functions add options that set keys of the scene in everyday words. `overrides` must outlive the command. When
// parsed, the options throw UsageError that begins with the option's name.

/// Reads a size in pixels: "1280x720", "1280,720", or a name such as "1080p" or "4K". Throws UsageError that begins
/// with the option's name.
renderer::Resized parse_size(const std::string& text, const std::string& option);

/// An option that sets a key of the scene.
struct KeyOption {
  const char* option;
  const char* key;
  const char* value = nullptr;  ///< value that a flag sets; null: the option takes a value
};

/// Adds the options. They take effect in the order in which they are added.
void add_keys(CLI::App& command, std::vector<Override>& overrides, std::initializer_list<KeyOption> options);
/// Adds `--resolution SIZE`.
void add_resolution(CLI::App& command, std::vector<Override>& overrides);
/// Adds `--view NAME`, a side to look from.
void add_side(CLI::App& command, std::vector<Override>& overrides);
/// Returns the names that `--view` takes.
std::string side_names();
/// Adds `--wind SPEED[@ANGLE]`.
void add_wind(CLI::App& command, std::vector<Override>& overrides);
/// Adds `--set`. Call it last, so that it overrides the options that set keys.
void add_set(CLI::App& command, std::vector<Override>& overrides);
/// Adds the options of a body.
void add_body(CLI::App& command, std::vector<Override>& overrides);
/// Adds the options of a garment and a body.
void add_garment_arguments(CLI::App& command, std::vector<Override>& overrides);

}  // namespace taut::app
