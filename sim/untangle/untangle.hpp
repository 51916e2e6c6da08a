#pragma once

#include "sim/solvers/bounded/settings.hpp"
#include "sim/untangle/contours.hpp"

namespace taut::sim {

/// How cloth is parted that crosses itself.
struct UntangleSettings {
  /// Of these `max_stretch` and `bound` are kept, as far as the start keeps them or can be brought to.
  BoundedSettings bounded;
  /// How far what crossed is moved apart, in m. Less leaves it nearer to where it was.
  double distance_m = 0.001;
  /// No vertex goes further than this many times the mean length of edges.
  double largest_move_edges = 5.0;
  int most_rounds = 200;  ///< of finding and moving; where nothing crosses any more they end
  /// It is to be cut as it was parted, by which it is stretched nowhere. Then it is parted too where layers
  /// are nearly as one at the start, and triangles that are flat or folded back are evened out.
  bool is_cut_anew = false;
};

/// Returns the pairs of triangles of the cloth that cross where its vertices are, in m.
using FindCrossings = std::function<std::vector<TrianglePair>(std::span<const Vec3> positions_m)>;

/// Where cloth was moved to.
struct Untangled {
  std::vector<Vec3> positions_m;  ///< per vertex
  std::size_t pairs_before = 0;   ///< of triangles that crossed
  std::size_t pairs_left = 0;
  double largest_move_m = 0.0;
};

/// Moves cloth, with or without pins, from a start in which it crosses itself to a near shape in which it
/// does not, or less. The part that a contour cuts off is moved back through the triangles that it came through, and
/// these the other way; where it cuts off nothing, edges are moved so that it shortens (Volino and
/// Magnenat-Thalmann 2006, "Resolving surface collisions through intersection contour minimization"). Of
/// walls that run along each other and face opposite ways the backs belong together, and which ends are wrong
/// is known without contours, if those say the same of most. Each move is spread over neighbours, and what it
/// stretches is shortened again. A start in which nothing crosses is returned as it is, if it is not cut
/// anew. Always the same for the same `start_m`.
Untangled untangle(const Garment& garment, std::vector<Vec3> start_m, const UntangleSettings& settings,
                   const FindCrossings& find_crossings);

}  // namespace taut::sim
