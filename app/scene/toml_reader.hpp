#pragma once

#include <filesystem>
#include <string>

#include "app/scene/scene_value.hpp"

namespace taut::app {

/// Reads a TOML file; returns its table. Throws InputError that names the file, the line and the reason.
Value read_toml(const std::filesystem::path& path);

/// Reads TOML from text. `name` stands for the file in messages.
Value read_toml_text(const std::string& text, const std::string& name);

/// Reads what follows `key=` on the command line. It is a TOML value, or else plain text, so that a user need
/// not quote twice.
Value read_toml_value(const std::string& text);

}  // namespace taut::app
