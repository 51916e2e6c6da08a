#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace taut::app {

/// The unit in the start tag of a 3MF model, in metres. Without a named unit it is a millimetre (3MF Core
/// Specification 1.3, section 3.4). Empty if the tag is missing or the unit is unknown.
std::optional<double> unit_of_model_part(std::string_view xml);

/// As above, from a 3MF file. Assimp reads such files but ignores the unit.
std::optional<double> unit_of_3mf(const std::filesystem::path& path);

/// Returns the beginning of the XML in which a 3MF file describes its model. Empty if it holds none.
std::string head_of_3mf(const std::filesystem::path& path);

}  // namespace taut::app
