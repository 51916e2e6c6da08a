#pragma once

#include <string_view>

#include "app/models/surface_colours.hpp"

struct aiScene;

namespace taut::app {

/// Reads base colours and the names of their images from the text of an OBJ's material library into the
/// materials of these names: Kd and map_Kd. What is damaged is passed over.
void read_mtl(std::string_view text, SurfaceColours& colours);

/// Returns the same of all materials of a scene, in their order. Those of glTF are linear, and multiply their
/// images; those of other formats are taken as what programs show, and their images replace them.
std::vector<SurfaceMaterial> materials_of(const aiScene& scene, bool is_gltf);

}  // namespace taut::app
