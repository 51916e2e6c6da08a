#pragma once

#include "sim/garment.hpp"
#include "sim/solvers/bounded/settings.hpp"

namespace taut::sim {

/// The indices of two triangles that cross.
using TrianglePair = std::array<Index, 2>;

/// The end of an edge that has come through.
enum class WrongEnd { unknown, first, second };

/// An edge that goes through a triangle.
struct Piercing {
  Index edge = 0;
  Index triangle = 0;
  /// The line along which the surfaces cross that it lies on: piercings of pairs of triangles that hang
  /// together have one number.
  Index contour = 0;
  double along = 0.0;              ///< where on the edge, 0 at its first end to 1
  Vec3 weights{0.0};               ///< where in the triangle, in parts of its corners
  Vec3 normal{0.0};                ///< of the triangle, of length 1, to the side of the edge's first end
  bool first_is_in_front = false;  ///< the edge's first end is on the side of the triangle's front
  bool is_opposed = false;         ///< the surface of the edge runs along the triangle and faces the other way
  /// A contour that parts the cloth cuts off the smaller part, as in the flood fill of Baraff, Witkin and
  /// Kass (2003), "Untangling cloth", but only if its triangles agree on the way out: where a tube goes
  /// through a sheet they do around the tube's end, and not around the round piece of the sheet within the
  /// tube.
  WrongEnd wrong = WrongEnd::unknown;
};

/// The segments in which pairs of triangles cross.
struct Contours {
  std::vector<Piercing> piercings;     ///< ordered by contour, edge and triangle
  std::vector<TrianglePair> touching;  ///< pairs of which no edge goes through the other
};

/// `positions_m` has one entry per vertex.
Contours find_contours(const Garment& garment, std::span<const TrianglePair> pairs, std::span<const Vec3> positions_m);

/// Returns whether what contours cut off is more often in front of surfaces that face the other way than
/// behind them: then these are walls whose backs belong together.
bool are_walls(std::span<const Piercing> piercings);

/// Takes ends in front of surfaces that face the other way to be wrong, whatever contours cut off.
void take_sides_of_walls(std::span<Piercing> piercings);

/// A vertex and a triangle, or two edges, that are near each other.
struct Gap {
  std::array<Index, 4> vertices{};
  std::array<double, 4> weights{};  ///< of the vertices where the two are nearest, below 0 for the second thing
  Vec3 apart{0.0};                  ///< from the second thing to the first, of length 1
  double width_m = 0.0;
};

/// Returns all that are narrower than `width_m`, or than `joined_width_m` where an edge joins the two, but
/// for those that touch. `positions_m` has one entry per vertex.
std::vector<Gap> find_gaps(const Garment& garment, double width_m, double joined_width_m,
                           std::span<const Vec3> positions_m);

/// How cloth is parted that crosses itself.
struct UntangleSettings {
  /// Of these `max_stretch` and `bound` are kept, as far as the start keeps them or can be brought to.
  BoundedSettings bounded;
  /// How far what crossed is moved apart, in m. Less leaves it nearer to where it was.
  double distance_m = 0.001;
  /// No vertex goes further than this many times the mean length of edges.
  double largest_move_edges = 5.0;
  int most_rounds = 200;  ///< of finding and moving; where nothing crosses any more they end
  /// Budget of work: pairs that cross, in all rounds together. When it is spent, the best shape so far is returned.
  std::size_t max_pairs = 2'000'000;
  /// It is to be cut as it was parted, by which it is stretched nowhere. Then it is parted too where layers
  /// are nearly as one at the start, and triangles that are flat or folded back are evened out.
  bool is_cut_anew = false;
};

/// Returns the pairs of triangles of the cloth that cross where its vertices are, in m.
using FindCrossings = std::function<std::vector<TrianglePair>(std::span<const Vec3> positions_m)>;

/// The outcome of parting cloth that crossed itself.
struct Untangling {
  std::size_t pairs_before = 0;  ///< of triangles that crossed
  std::size_t pairs_left = 0;
  std::size_t pairs_found = 0;  ///< in all rounds together
  bool is_given_up = false;     ///< the budget of work was spent
  double largest_move_m = 0.0;
};

/// The same, and where cloth was moved to.
struct Untangled : Untangling {
  std::vector<Vec3> positions_m;  ///< per vertex
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
