#pragma once

#include "app/models/hanging/garment_parts.hpp"

namespace taut::app {

/// Pieces so far from nearly all of a model's area that they cannot belong to the garment, such as a button at the
/// wrong end of a scene.
struct Strays {
  std::size_t triangles = 0;
  double area_share = 0.0;  ///< fraction of the whole area
  double distance = 0.0;    ///< largest distance from the middle of the rest, in the file's unit
};

/// Removes the strays from the model's triangles and returns a summary. Removes none from a model with positions that
/// are not finite.
Strays remove_strays(sim::Mesh& mesh);

/// Returns a sentence for people: "8 triangles with 0.02 % of its area lie 107 m away and are left out".
std::string describe(const Strays& strays, double metres_per_unit);

/// Turns surfaces that face inwards: surfaces of a part with several openings or none, such as a shirt, whose normals
/// point mostly towards the part's centre of mass. A piece with one border has no inside and is unchanged. Returns the
/// number of turned triangles. Requires the adjacency and the parts of this mesh.
std::size_t turn_outside_out(std::span<const GarmentPart> parts, const sim::Adjacency& adjacency, sim::Mesh& mesh);

/// Sews small parts, such as buttons, labels, pockets and belts, to the cloth that they lie on or near, so that they
/// move with it. Each gets triangles, like stitches, from its own vertices to corners of the triangles below. Nothing
/// is moved. Returns the number of parts sewn on. Requires the parts of this mesh.
std::size_t sew_on_trims(std::span<const GarmentPart> parts, double metres_per_unit, sim::Mesh& mesh);

}  // namespace taut::app
