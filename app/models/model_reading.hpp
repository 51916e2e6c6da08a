#pragma once

#include <filesystem>

#include "app/models/model_arrays.hpp"

namespace taut::app {

/// Reads an OBJ file, or any other format of the assimp library, in this process. A damaged file can crash
/// the process, so programs call import_garment() instead. So may a damaged image. Throws InputError with the
/// reason, without the file name.
ModelArrays read_model(const std::filesystem::path& path, ReadParts parts);

}  // namespace taut::app
