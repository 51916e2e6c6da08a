#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace taut::app {

/// The unit in the start tag of a 3MF model, in metres; a millimetre where it names none, by the
/// specification (3MF Core 1.3, 3.4). Nothing where there is no such tag or the unit is unknown.
std::optional<double> unit_of_model_part(std::string_view xml);

/// The same from a 3MF file: assimp reads the model and passes the unit over.
std::optional<double> unit_of_3mf(const std::filesystem::path& path);

}  // namespace taut::app
