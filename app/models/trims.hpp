#pragma once

#include <cstddef>
#include <span>

#include "app/models/garment_parts.hpp"

namespace taut::app {

/// Sews small parts, such as buttons, labels and trims, to the cloth that they lie on, so that they go with
/// it: each gets up to three triangles, like stitches, from a vertex of its own to the corners of the
/// triangle below. Nothing is moved. Returns how many parts were sewn on. Requires the parts of this mesh.
std::size_t sew_on_trims(std::span<const GarmentPart> parts, double metres_per_unit, sim::Mesh& mesh);

}  // namespace taut::app
