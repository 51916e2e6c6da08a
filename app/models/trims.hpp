#pragma once

#include <cstddef>
#include <span>

#include "app/models/garment_parts.hpp"

namespace taut::app {

/// Sews small parts, such as buttons, labels, pockets and belts, to the cloth that they lie on or near, so
/// that they go with it: each gets triangles, like stitches, from vertices of its own to corners of the
/// triangles below. Nothing is moved. Returns how many parts were sewn on. Requires the parts of this mesh.
std::size_t sew_on_trims(std::span<const GarmentPart> parts, double metres_per_unit, sim::Mesh& mesh);

}  // namespace taut::app
