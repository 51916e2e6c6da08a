#pragma once

#include <filesystem>

#include "app/models/model_arrays.hpp"

namespace taut::app {

/// Reads OBJ files, and any other model the assimp library can, in this process: damaged files can crash it,
/// so `import_garment` does this in another one. Throws InputError with the reason, which does not name the
/// file.
ModelArrays read_model(const std::filesystem::path& path);

}  // namespace taut::app
