#pragma once

#include <cstddef>
#include <span>

#include "app/models/garment_parts.hpp"

namespace taut::app {

/// Turns the surfaces that face inwards: those of a part with several openings or none, such as a shirt,
/// whose normals point mostly towards the part's centre of mass. A piece with one border has no inside and is
/// left alone. Returns how many triangles were turned. Requires the adjacency and the parts of this mesh.
std::size_t turn_outside_out(std::span<const GarmentPart> parts, const sim::Adjacency& adjacency,
                             sim::Mesh& mesh);

}  // namespace taut::app
