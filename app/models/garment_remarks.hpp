#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "app/models/garment_loading.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// What was guessed, repaired or chosen because the scene does not say it, one line each.
std::vector<std::string> remarks_of(const LoadedGarment& loaded);

/// What triangles cross in the shape the garment begins in, as one line; empty: none do.
std::string remark_on_crossings(const GarmentInScene& loaded);

/// Prints both after the name of the garment's file.
void print_remarks(const Scene& scene, const LoadedGarment& loaded, std::FILE* output = stdout);

}  // namespace taut::app
