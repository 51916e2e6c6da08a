#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/scene/scene.hpp"
#include "app/scene/scene_value.hpp"

namespace taut::app {

/// One key set on the command line.
struct Override {
  std::string key;
  std::string value;
  std::string option;  ///< as written, for messages: "--set solver.substeps=40"
};

/// "KEY=VALUE". Throws UsageError without "=".
Override parse_override(const std::string& text);

/// Reads a scene. Throws InputError naming the file, the line, the key, what was found and what is expected;
/// UsageError for an override.
Scene read_scene_file(const std::filesystem::path& path, std::span<const Override> overrides = {});

/// The same of a text that was read before. `name` is its file's: relative garment files are looked for
/// beside it.
Scene read_scene_text(const std::string& text, const std::string& name,
                      std::span<const Override> overrides = {});

/// Changes keys of a scene made otherwise. Throws UsageError.
void apply_overrides(std::span<const Override> overrides, Scene& scene);

/// Every key with its value, nested as in a file.
Value scene_settings(const Scene& scene);

/// All keys with unit, default, range and meaning, for people.
std::string scene_help();

}  // namespace taut::app
