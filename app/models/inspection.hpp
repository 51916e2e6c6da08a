#pragma once

#include "app/models/garment_loading.hpp"
#include "app/scene/scene_key.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {

/// The content of a model file and how it maps to springs. Of a model that follows a fitted mesh, parts, springs and
/// what is hung are those of that mesh.
struct Inspection {
  Json facts;                           ///< for programs: counts, lengths in m, areas in m2, and texts for people
  std::vector<CrossingPair> crossings;  ///< in the shape it begins in
};

/// How many springs there are of each kind, by their names.
Json springs_json(const sim::Springs& springs);

/// The garment must have been read from a file.
Inspection inspect_garment(const Scene& scene, const LoadedGarment& loaded);

/// The facts of an inspection as text for people: a line for each, by the name that programs read.
std::string describe(const Json& facts);

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
