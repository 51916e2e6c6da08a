#pragma once

#include "sim/garment.hpp"
#include "sim/solvers/bounded/settings.hpp"

namespace taut::sim {

/// Indices of two crossing triangles.
using TrianglePair = std::array<Index, 2>;

/// End of an edge that is on the wrong side.
enum class WrongEnd { unknown, first, second };

/// Edge that pierces a triangle.
struct Piercing {
  Index edge = 0;
  Index triangle = 0;
  /// Contour it lies on: the line along which surfaces cross. Piercings of connected pairs of triangles have the same
  /// number.
  Index contour = 0;
  double along = 0.0;              ///< position on the edge, 0 at its first end to 1
  Vec3 weights{0.0};               ///< position in the triangle, as corner weights
  Vec3 normal{0.0};                ///< unit normal of the triangle, on the side of the edge's first end
  bool first_is_in_front = false;  ///< the edge's first end is in front of the triangle
  bool is_opposed = false;         ///< the edge's surface is nearly parallel to the triangle and faces the other way
  /// A contour that divides the cloth cuts off the smaller part, as in the flood fill of Baraff, Witkin and Kass
  /// (2003), "Untangling cloth". It counts only if its triangles agree on the direction out. Where a tube pierces a
  /// sheet, they agree around the tube's end, but not around the round patch of the sheet within the tube.
  WrongEnd wrong = WrongEnd::unknown;
};

/// Contours along which triangles cross.
struct Contours {
  std::vector<Piercing> piercings;     ///< ordered by contour, edge and triangle
  std::vector<TrianglePair> touching;  ///< crossing pairs in which no edge pierces the other triangle
};

/// Returns the piercings of each pair in turn. Their contours are the numbers of their pairs, and no end is known to be
/// wrong. `positions_m` has one entry per vertex.
std::vector<Piercing> find_piercings(const Garment& garment, std::span<const TrianglePair> pairs,
                                     std::span<const Vec3> positions_m);

/// `positions_m` has one entry per vertex.
Contours find_contours(const Garment& garment, std::span<const TrianglePair> pairs, std::span<const Vec3> positions_m);

/// Returns whether the cut-off parts are more often in front of opposed surfaces than behind them. The surfaces are
/// then two walls whose backs belong together.
bool are_walls(std::span<const Piercing> piercings);

/// Marks ends in front of opposed surfaces as wrong, whatever contours cut off.
void take_sides_of_walls(std::span<Piercing> piercings);

/// Near pair of a vertex and a triangle, or of two edges.
struct Gap {
  std::array<Index, 4> vertices{};
  std::array<double, 4> weights{};  ///< vertex weights of the closest points, below 0 for the second primitive
  Vec3 apart{0.0};                  ///< unit vector from the second primitive to the first
  double width_m = 0.0;
};

/// Returns all gaps narrower than `width_m`, or than `joined_width_m` if an edge joins the two primitives, except those
/// of width 0. `positions_m` has one entry per vertex.
std::vector<Gap> find_gaps(const Garment& garment, double width_m, double joined_width_m,
                           std::span<const Vec3> positions_m);

/// Settings for untangling cloth that crosses itself.
struct UntangleSettings {
  /// Only `max_stretch` and `bound` apply. They are kept if the start keeps them or can be moved within them.
  BoundedSettings bounded;
  /// Final distance of surfaces that crossed, in m. Lower values stay closer to the start.
  double distance_m = 0.001;
  /// Largest motion of a vertex, in mean edge lengths.
  double max_move_edges = 5.0;
  int max_rounds = 200;  ///< rounds of search and motion; they end early when nothing crosses
  /// Budget of work: the number of crossing pairs, summed over all rounds. When it is spent, the best shape so far is
  /// returned.
  std::size_t max_pairs = 2'000'000;
  /// The untangled shape becomes the rest shape, so stretch does not matter. Layers that nearly coincide at the start
  /// are separated too, and flat or folded triangles are evened out.
  bool is_cut_anew = false;
};

/// Returns the pairs of cloth triangles that cross at these positions, in m.
using FindCrossings = std::function<std::vector<TrianglePair>(std::span<const Vec3> positions_m)>;

/// Report of untangling.
struct UntangleReport {
  std::size_t pairs_before = 0;  ///< crossing pairs of triangles at the start
  std::size_t pairs_left = 0;
  std::size_t pairs_found = 0;  ///< sum over all rounds
  bool is_given_up = false;     ///< the budget of work was spent
  double max_move_m = 0.0;
};

/// Report with the resulting shape.
struct UntangleResult : UntangleReport {
  std::vector<Vec3> positions_m;  ///< per vertex
};

/// Moves cloth from a start in which it crosses itself to a near shape with fewer crossings or none. Pins are ignored.
/// A part that a contour cuts off is moved back through the triangles that it pierces, and these the other way. If a
/// contour cuts off nothing, edges are moved so that it shortens (Volino and Magnenat-Thalmann 2006, "Resolving surface
/// collisions through intersection contour minimization"). If two nearly parallel walls face opposite ways, their backs
/// belong together, and wrong ends are known without contours; this is assumed if most contours agree. Each motion
/// spreads over neighbours, and the stretch that it causes is reduced again. A start without crossings is returned
/// unchanged unless it is cut anew. The result depends on the arguments alone.
UntangleResult untangle(const Garment& garment, std::vector<Vec3> start_m, const UntangleSettings& settings,
                        const FindCrossings& find_crossings);

}  // namespace taut::sim
