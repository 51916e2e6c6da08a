#pragma once

#include <optional>

#include "app/models/file_vertices.hpp"
#include "sim/garment.hpp"
#include "sim/surroundings.hpp"

namespace taut::app {

/// A distance in metres for keeping the layers of the garment apart: about the length of its edges. It is
/// also less than half the gap between parts that lie over each other. Vertices modelled closer than twice
/// the distance count as one cloth (sim/contact/neighbour_list.hpp). Returns 0 if the edges are very short
/// for the garment's size.
double suitable_layer_distance(const sim::Garment& garment);

/// Completes the surroundings for the simulation. Sets the distance of layers: `layer_distance_m`, or if
/// empty suitable_layer_distance(). Changes the vertices of forces from numbers of the file to those of the
/// mesh. Throws InputError for a force at a vertex that does not exist.
sim::Surroundings settled(sim::Surroundings surroundings, std::optional<double> layer_distance_m,
                          const sim::Garment& garment, const FileVertices& file_vertices);

}  // namespace taut::app
