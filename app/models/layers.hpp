#pragma once

#include "sim/garment.hpp"

namespace taut::app {

/// A distance in metres for keeping the layers of the garment apart: about the length of its edges. It is
/// also less than half the gap between parts that lie over each other. Vertices modelled closer than twice
/// the distance count as one cloth (sim/contact/neighbour_list.hpp). Returns 0 if the edges are very short
/// for the garment's size.
double suitable_layer_distance(const sim::Garment& garment);

}  // namespace taut::app
