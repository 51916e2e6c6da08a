#pragma once

#include "app/scene/scene.hpp"
#include "sim/untangle/untangle.hpp"

namespace taut::app {

/// Crossings of the cloth with itself, or with a body.
struct SceneCrossings {
  std::optional<std::size_t> body = {};  ///< index of the body; empty for the cloth itself
  /// Crossing pairs; for a body without a mesh, the triangles that enter it, with `second` 0 and the triangle's middle.
  std::vector<sim::CrossingPair> pairs = {};
};

/// Returns the crossings of the cloth with itself and then with each body at this time. An entry may have no pairs.
std::vector<SceneCrossings> scene_crossings(const sim::Surface& cloth, std::span<const sim::Body> bodies,
                                            double time_s);

/// Returns the crossings with one of the bodies.
SceneCrossings crossings_with(std::span<const sim::Body> bodies, std::size_t body, double time_s,
                              const sim::Surface& cloth);

/// Returns "2 pairs of triangles cross, the first: triangle 7 (vertices 1, 2, 3) and triangle 9 (vertices 4,
/// 5, 6) at [0.10000, 0.20000, 0.30000] m". The pairs must be of the cloth itself, at least one.
std::string describe(const sim::Surface& cloth, std::span<const sim::CrossingPair> pairs);

/// Returns the number of pairs, their kind, and the first with its place. Requires at least one pair.
std::string describe(const SceneCrossings& crossings, const sim::Surface& cloth, std::span<const sim::Body> bodies);

/// Returns "the body 'ball'", or "body 0" if it has no name.
std::string describe_body(std::span<const sim::Body> bodies, std::size_t body);

/// Returns the positions of the vertices of a body's mesh at this time, in m.
std::vector<sim::Vec3> mesh_positions_m(const sim::Body& body, double time_s);

using sim::UntangleReport;

/// Moves the garment, which begins in `start_m`, to a near shape that crosses itself less or not at all (sim/untangle).
/// The bound of the scene's solver is kept unless `is_cut_anew`. Calls `tell` with the number of crossing pairs in each
/// round. Returns an empty value, and moves nothing, if there is nothing to untangle.
std::optional<UntangleReport> untangle_start(const Scene& scene, const sim::Garment& garment, bool is_cut_anew,
                                             std::vector<sim::Vec3>& start_m,
                                             const std::function<void(const std::string&)>& tell);

/// Returns "of 4 pairs of triangles that crossed at the start 0 are left, ...".
std::string describe(const UntangleReport& untangling);

}  // namespace taut::app
