#pragma once

#include "app/models/garment_loading.hpp"

namespace taut::app {

/// Guesses, repairs and choices that the scene does not make, one line each.
std::vector<std::string> remarks_of(const LoadedGarment& loaded);

/// Faults of the shape the cloth begins in.
struct StartRemarks {
  std::vector<std::string> lines;  ///< for people
  std::size_t crossings = 0;       ///< pairs of triangles that cross, and parts of cloth wholly within bodies
};

/// Says what is wrong: triangles that cross, triangles and pins in bodies, and bodies that cross themselves.
StartRemarks remarks_on_start(const Scene& scene, const GarmentInScene& loaded);
/// The same of one of the bodies and cloth that is here at this time.
StartRemarks remarks_on_body(std::span<const sim::Body> bodies, std::size_t body, double time_s, const Surface& cloth,
                             std::span<const sim::Index> pins);

/// Prints both after the name of the garment's file.
void print_remarks(const Scene& scene, const LoadedGarment& loaded, std::FILE* output = stdout);

}  // namespace taut::app
