#pragma once

#include <filesystem>
#include <string>

#include "app/scene/scene_value.hpp"

namespace taut::app {

/// The table in a TOML file. Throws InputError naming file, line and reason.
Value read_toml(const std::filesystem::path& path);

/// The table in a text that is no file of its own; `name` is for messages.
Value read_toml_text(const std::string& text, const std::string& name);

/// What stands behind `key=` on the command line: a TOML value, or else plain text, so that a shell user need
/// not quote twice.
Value read_toml_value(const std::string& text);

}  // namespace taut::app
