#pragma once

#include <filesystem>

#include "app/models/model_arrays.hpp"

struct aiScene;

namespace taut::app {

/// Reads an OBJ file, or any other format of the assimp library, in this process. A damaged file can crash
/// the process, so programs call import_garment() instead. So may a damaged image. Throws InputError with the
/// reason, without the file name.
ModelArrays read_model(const std::filesystem::path& path, ReadParts parts);

/// Reads base colours and the names of their images from the text of an OBJ's material library into the
/// materials of these names: Kd and map_Kd. Damaged entries are passed over.
void read_mtl(std::string_view text, SurfaceColours& colours);

}  // namespace taut::app
