#pragma once

#include <vector>

#include "app/models/garment_parts.hpp"

namespace taut::app {

/// Returns the vertices around the neck of a garment with a hood: those just above the level at which it
/// widens into shoulders. `across` is the axis of its width, 0 or 2. Empty if there is no hood: what is above
/// that level has to be high, and open over most of its height, as at a face.
std::vector<sim::Index> neck_below_hood(const sim::Mesh& mesh, const GarmentPart& part, int across);

}  // namespace taut::app
