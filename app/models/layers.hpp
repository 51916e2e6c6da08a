#pragma once

#include "app/models/file_vertices.hpp"
#include "sim/garment.hpp"
#include "sim/surroundings.hpp"

namespace taut::app {

/// In place of Surroundings::layer_distance_m: the one that suits the garment.
inline constexpr double layer_distance_from_mesh = -1.0;

/// A distance in metres that keeps the garment's layers apart: about the length of its edges, but less than
/// half the way between parts that lie over one another, since what is modelled nearer than twice the
/// distance counts as one cloth (sim/contact/self_collision.hpp). 0 where the edges are next to nothing.
double suitable_layer_distance(const sim::Garment& garment);

/// The surroundings as the simulation needs them, with the suitable distance where it is left to the mesh and
/// forces at vertices of the mesh, where the scene means those of the garment's file. Throws InputError on a
/// force at a vertex that is not there.
sim::Surroundings settled(sim::Surroundings surroundings, const sim::Garment& garment,
                          const FileVertices& file_vertices);

}  // namespace taut::app
