#pragma once

#include <filesystem>
#include <string>

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

/// Throws by `fail` where `garment`, which the file names, is not there.
void require_garment_of(const ValueTable& file, const Source& source, const std::filesystem::path& garment);

/// The same of a garment named on `line`; 0: nowhere.
void require_garment(const std::filesystem::path& garment, const Source& source, int line);

/// Puts a value where a key with its sections ("solver.substeps") belongs.
void insert(ValueTable& table, const std::string& name, const Value& value);

}  // namespace taut::app
