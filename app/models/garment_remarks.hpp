#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "app/models/garment_loading.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// What was guessed, repaired or chosen because the scene does not say it, one line each.
std::vector<std::string> remarks_of(const LoadedGarment& loaded);

/// What is wrong with the shape the garment begins in, one line each: triangles that cross, triangles and
/// pins in bodies, and bodies that cross themselves. Of meshes the pins within are not known.
std::vector<std::string> remarks_on_start(const Scene& scene, const GarmentInScene& loaded);

/// Prints both after the name of the garment's file.
void print_remarks(const Scene& scene, const LoadedGarment& loaded, std::FILE* output = stdout);

}  // namespace taut::app
