#pragma once

#include "app/scene/scene.hpp"
#include "app/verify/crossing_pairs.hpp"
#include "sim/untangle/untangle.hpp"

namespace taut::app {

/// Where the cloth crosses itself, or a body.
struct SceneCrossings {
  std::optional<std::size_t> body = {};  ///< its place among the bodies; empty: the cloth itself
  /// For a body that is no mesh, the triangles that enter it, with `second` 0 and the triangle's middle.
  std::vector<CrossingPair> pairs = {};
};

/// Returns the crossings of the cloth with itself and then with each body, where it is at this time; of those
/// without any an entry without pairs.
std::vector<SceneCrossings> scene_crossings(const Surface& cloth, std::span<const sim::Body> bodies, double time_s);

/// The same with one of the bodies.
SceneCrossings crossings_with(std::span<const sim::Body> bodies, std::size_t body, double time_s, const Surface& cloth);

/// Returns how many pairs there are, of what, and the first with its place. Requires at least one pair.
std::string describe(const SceneCrossings& crossings, const Surface& cloth, std::span<const sim::Body> bodies);

/// Returns "the body 'ball'", or "body 0" if it has no name.
std::string describe_body(std::span<const sim::Body> bodies, std::size_t body);

/// Returns where the vertices of a body that is a mesh are at this time, in m.
std::vector<sim::Vec3> mesh_positions_m(const sim::Body& body, double time_s);

using sim::Untangling;

/// Moves the garment, which begins in `start_m`, to a near shape in which it does not cross itself, or less
/// (sim/untangle), with the bound of the scene's solver, if it is not cut anew. Tells how many pairs cross,
/// round by round. Returns an empty value, and moves nothing, if there is nothing to be parted.
std::optional<Untangling> untangle_start(const Scene& scene, const sim::Garment& garment, bool is_cut_anew,
                                         std::vector<sim::Vec3>& start_m,
                                         const std::function<void(const std::string&)>& tell);

/// Returns "of 4 pairs of triangles that crossed at the start 0 are left, ...".
std::string describe(const Untangling& untangling);

}  // namespace taut::app
