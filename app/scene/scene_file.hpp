#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>

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

/// Throws by `fail` unless the file names one garment: a model or a grid.
void require_one_garment(const ValueTable& file, const Source& source);

/// The keys of [garment] that name files.
inline constexpr std::array garment_files = {std::pair("file", &GarmentSource::file),
                                             std::pair("start", &GarmentSource::start)};

/// Throws by `fail` where one of the garment's files that the scene file names is not there. Not looked for
/// is what `used` does not have any more as it was `named`.
void require_garment_of(const ValueTable& file, const Source& source, const GarmentSource& named,
                        const GarmentSource& used);

/// The same of one file, which the key garment.KEY names on `line`; 0: nowhere.
void require_named(const std::string& key, const std::filesystem::path& named, const Source& source,
                   int line);

/// Puts a value where a key with its sections ("solver.substeps") belongs.
void insert(ValueTable& table, const std::string& name, const Value& value);

}  // namespace taut::app
