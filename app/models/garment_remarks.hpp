#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "app/models/garment_loading.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// What was guessed, repaired and chosen that the scene does not say, a line each; nothing is done silently.
std::vector<std::string> remarks_of(const LoadedGarment& loaded);

/// These lines, with the name of the garment's file.
void print_remarks(const Scene& scene, const LoadedGarment& loaded, std::FILE* output = stdout);

}  // namespace taut::app
