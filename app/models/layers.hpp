#pragma once

#include <optional>

#include "app/models/file_vertices.hpp"
#include "sim/garment.hpp"
#include "sim/surroundings.hpp"

namespace taut::app {

/// A distance in metres that keeps the garment's layers apart: about the length of its edges, but less than
/// half the way between parts that lie over one another, since what is modelled nearer than twice the
/// distance counts as one cloth (sim/contact/neighbour_list.hpp). 0 where the edges are next to nothing.
double suitable_layer_distance(const sim::Garment& garment);

/// The surroundings as the simulation needs them, with the distance of layers, the suitable one where none is
/// given, and forces at vertices of the mesh, where the scene means those of the garment's file. Throws
/// InputError on a force at a vertex that is not there.
sim::Surroundings settled(sim::Surroundings surroundings, std::optional<double> layer_distance_m,
                          const sim::Garment& garment, const FileVertices& file_vertices);

}  // namespace taut::app
