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

/// Parts of a model that are no cloth: closed and thick, such as a stand, a head, a body or a sole.
struct RigidParts {
  sim::Mesh mesh;  ///< their triangles, with all positions of the model, in m where it is placed
  std::size_t count = 0;
  double area_share = 0.0;  ///< fraction of the whole area
  bool are_all = false;     ///< true if hardly anything else is there, so that they are the garment
  bool is_body = false;     ///< true if cloth cannot enter them; else they are left out
};

/// Returns a sentence for people: "2 parts with 58 % of its area are no cloth, ...".
std::string describe(const RigidParts& rigid);

/// Removes the rigid parts from the model's triangles and returns them. Removes none if hardly any cloth would be left,
/// and no small ones that lie on cloth, such as buttons. Throws std::invalid_argument as sim::weld_and_validate does.
RigidParts remove_rigid_parts(sim::Mesh& mesh);

/// Turns surfaces that face inwards: surfaces of a part with several openings or none, such as a shirt, whose normals
/// point mostly towards the part's centre of mass. A piece with one border has no inside and is unchanged. Returns the
/// number of turned triangles. Requires the adjacency and the parts of this mesh.
std::size_t turn_outside_out(std::span<const GarmentPart> parts, const sim::Adjacency& adjacency, sim::Mesh& mesh);

/// Sews small parts, such as buttons, labels, pockets and belts, to the cloth that they lie on or near, so that they
/// move with it. Each gets triangles, like stitches, from its own vertices to corners of the triangles below. Nothing
/// is moved. Returns the number of parts sewn on. Requires the parts of this mesh.
std::size_t sew_on_trims(std::span<const GarmentPart> parts, double metres_per_unit, sim::Mesh& mesh);

}  // namespace taut::app
