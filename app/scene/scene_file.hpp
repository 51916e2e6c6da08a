#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>

#include "app/scene/scene.hpp"
#include "app/scene/scene_value.hpp"

namespace taut::app {

/// A key that was set on the command line.
struct Override {
  std::string key;
  std::string value;
  std::string option;  ///< the whole option, for messages: "--set solver.substeps=40"
};

/// Reads "KEY=VALUE". Throws UsageError if there is no "=".
Override parse_override(const std::string& text);

/// Requires that the file names exactly one garment: a model or a grid. Throws by `fail` (scene_value.hpp).
void require_one_garment(const ValueTable& file, const Source& source);

/// The keys of [garment] that name files, and their members.
inline constexpr std::array garment_files = {std::pair("file", &GarmentSource::file),
                                             std::pair("start", &GarmentSource::start)};

/// Requires that the garment's files exist. `named` is what the scene file says; `used` is that after
/// overrides. A file that was overridden is not checked. Throws by `fail`.
void require_garment_of(const ValueTable& file, const Source& source, const GarmentSource& named,
                        const GarmentSource& used);

/// Requires that the file of key garment.KEY exists. `line` is where the scene file names it; 0: nowhere.
/// Throws by `fail`.
void require_named(const std::string& key, const std::filesystem::path& named, const Source& source,
                   int line);

/// Inserts a value under a key with its sections, such as "solver.substeps".
void insert(ValueTable& table, const std::string& name, const Value& value);

}  // namespace taut::app
