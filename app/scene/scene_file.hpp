#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>

#include "app/scene/scene.hpp"

namespace taut::app {

/// A key that was set on the command line.
struct Override {
  std::string key;
  std::string value;
  std::string option;  ///< the whole option, for messages: "--set solver.substeps=40"
};

/// Reads "KEY=VALUE". Throws UsageError if there is no "=".
Override parse_override(const std::string& text);

/// The keys of [garment] that name files, and their members.
inline constexpr std::array garment_files = {std::pair("file", &GarmentSource::file),
                                             std::pair("start", &GarmentSource::start)};
/// The same of the keys of [[bodies]].
inline constexpr std::array body_files = {std::pair("file", &BodySource::file),
                                          std::pair("motion", &BodySource::motion)};

}  // namespace taut::app
