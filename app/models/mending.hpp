#pragma once

#include "app/models/garment_parts.hpp"

namespace taut::app {

/// Turns the surfaces that face inwards: those of a part with several openings or none, such as a shirt,
/// whose normals point mostly towards the part's centre of mass. A piece with one border has no inside and is
/// left alone. Returns how many triangles were turned. Requires the adjacency and the parts of this mesh.
std::size_t turn_outside_out(std::span<const GarmentPart> parts, const sim::Adjacency& adjacency, sim::Mesh& mesh);

/// Sews small parts, such as buttons, labels, pockets and belts, to the cloth that they lie on or near, so
/// that they go with it: each gets triangles, like stitches, from vertices of its own to corners of the
/// triangles below. Nothing is moved. Returns how many parts were sewn on. Requires the parts of this mesh.
std::size_t sew_on_trims(std::span<const GarmentPart> parts, double metres_per_unit, sim::Mesh& mesh);

}  // namespace taut::app
