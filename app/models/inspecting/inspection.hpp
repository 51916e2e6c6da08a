#pragma once

#include "app/models/garment_loading.hpp"
#include "app/scene/scene_key.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {

/// Content of a model file and its mapping to springs. Parts, springs and hanging are the fitted mesh's if the model
/// follows one.
struct Inspection {
  Json facts;  ///< facts for programs: counts, lengths in m, areas in m2, and texts for people
  std::vector<sim::CrossingPair> crossings;  ///< crossings of the shape in which it begins
};

/// Returns the number of springs of each kind, by their names.
Json springs_json(const sim::Springs& springs);

/// Requires a garment that was read from a file.
Inspection inspect_garment(const Scene& scene, const LoadedGarment& loaded);

/// Returns the facts of an inspection as text for people: a line for each, with the name that programs read.
std::string describe(const Json& facts);

}  // namespace taut::app
