#pragma once

#include "app/models/garment_loading.hpp"

namespace taut::app {

/// Returns guesses, repairs and choices that the scene does not make, one line each.
std::vector<std::string> collect_remarks(const LoadedGarment& loaded);

/// Faults of the shape in which the cloth begins.
struct StartRemarks {
  std::vector<std::string> lines;  ///< for people
  std::size_t crossings = 0;       ///< count of crossing pairs of triangles, and of parts wholly within bodies
};

/// Returns the faults: triangles that cross, triangles and pins in bodies, and bodies that cross themselves.
StartRemarks remarks_on_start(const Scene& scene, const GarmentInScene& loaded, std::span<const sim::Body> bodies);
/// Returns the faults with one of the bodies, for cloth at this time.
StartRemarks remarks_on_body(std::span<const sim::Body> bodies, std::size_t body, double time_s,
                             const sim::Surface& cloth, std::span<const sim::Index> pins);

/// Prints the lines of collect_remarks() and remarks_on_start() after the name of the garment's file.
void print_remarks(const Scene& scene, const LoadedGarment& loaded, std::span<const sim::Body> bodies,
                   std::FILE* output = stdout);

}  // namespace taut::app
