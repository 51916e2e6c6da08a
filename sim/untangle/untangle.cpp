#include "sim/untangle/untangle.hpp"

#include "sim/pins.hpp"
#include "sim/solvers/bounded/within_bound.hpp"

namespace taut::sim {
namespace {

/// Of each round, in mean lengths of edges.
constexpr double largest_step_edges = 0.5;
/// The same where no side is known to be wrong. Smaller steps end where contours are long and straight.
constexpr double largest_blind_step_edges = 4.0;
/// The steepest an edge is taken to run along the triangle that it goes through: the cosine to its normal.
constexpr double least_cosine = 0.1;
/// Rings of neighbours that go along with a vertex that is moved, how much they weigh against it, and how
/// much against them that they stay.
constexpr int rings = 24;
constexpr double pull_of_neighbours = 0.25;
constexpr double pull_of_place = 0.005;
/// Sweeps over what a round has stretched.
constexpr int shortening_sweeps = 10;
/// The narrowest gap that is left and the one that narrower ones become, in parts of the distance.
constexpr double least_gap = 0.5;
constexpr double wider_gap = 1.0;
/// Neighbours are near. Contact keeps none apart that are this near at rest, as they would touch there.
constexpr double least_joined_gap_m = 1e-5;
/// Height over the longest side of triangles that are flat, and the cosine between the normals of two at an
/// edge where they are folded back.
constexpr double flat = 0.2;
constexpr double folded_back = -0.9;
/// Rounds without fewer pairs, after which there will not be.
constexpr int most_rounds_in_vain = 60;

/// Where vertices are to be moved, each to the mean of what is asked of it.
struct Moves {
  explicit Moves(std::size_t count) : sums_m(count, Vec3(0.0)), weights(count, 0.0) {}

  void add(Index vertex, const Vec3& move_m, double weight) {
    sums_m[vertex] += weight * move_m;
    weights[vertex] += weight;
  }
  void add(const Triangle& t, const Vec3& move_m, const Vec3& weights_of_corners) {
    for (int k = 0; k < 3; ++k) add(t[static_cast<std::size_t>(k)], move_m, weights_of_corners[k]);
  }

  std::vector<Vec3> sums_m;
  std::vector<double> weights;
};

/// The moves, with neighbours that go along: a field in which each vertex is drawn to what is asked of it, to
/// its neighbours and to its place.
std::vector<Vec3> spread(const Adjacency& adjacency, const Moves& asked) {
  std::vector<Vec3> field(asked.weights.size(), Vec3(0.0)), next = field;
  for (int ring = 0; ring < rings; ++ring) {
    for (std::size_t v = 0; v < field.size(); ++v) {
      Vec3 sum = asked.sums_m[v];
      double weight = asked.weights[v] + pull_of_place;
      for (const Index e : adjacency.vertex_edges[v]) {
        sum += pull_of_neighbours * field[other_end(adjacency.edges[e], static_cast<Index>(v))];
        weight += pull_of_neighbours;
      }
      next[v] = sum / weight;
    }
    field.swap(next);
  }
  return field;
}

/// A near shape that keeps the bound, with contact left out. Springs that pull against each other settle
/// slowly by sweeps.
std::vector<Vec3> within_bound(const Garment& garment, const BoundedSettings& settings, std::vector<Vec3> positions_m) {
  const Pins none = make_pins(garment, {});
  State state = make_state(garment);
  state.current = state.previous = std::move(positions_m);
  move_within_bound(garment, none, settings, state);
  std::ignore = keeps_bound_in_double(garment, none, settings, state.current);
  return state.current;
}

/// Flaws of a shape: pairs that cross, by how much it exceeds the bound in m, gaps that are too
/// narrow, vertices where it is to be evened out.
using Flaws = std::tuple<std::size_t, double, std::size_t, std::size_t>;

/// One way to untangle from the start.
class Attempt {
 public:
  Attempt(const Garment& garment, const UntangleSettings& settings, std::span<const Vec3> start_m)
      : garment_(garment),
        settings_(settings),
        free_(make_pins(garment, {})),
        start_m_(start_m),
        positions_m_(start_m.begin(), start_m.end()),
        edge_m_(mean_edge_m(garment.springs)) {}

  /// Ends in `best`, if it comes to fewer pairs.
  void run(const FindCrossings& find_crossings, bool by_walls, Untangled& best) {
    int in_vain = 0;
    for (int round = 0; round < settings_.most_rounds && in_vain < most_rounds_in_vain; ++round) {
      const std::vector<TrianglePair> pairs = find_crossings(positions_m_);
      const std::vector<Gap> gaps = pairs.empty() ? narrow_gaps() : std::vector<Gap>{};
      const std::vector<Index> uneven =
          pairs.empty() && settings_.is_cut_anew ? uneven_vertices() : std::vector<Index>{};
      const double excess_m = settings_.is_cut_anew ? 0.0 : largest_excess_m(garment_, settings_.bounded, positions_m_);
      in_vain = keep_least({pairs.size(), excess_m, gaps.size(), uneven.size()}) ? 0 : in_vain + 1;
      if (!pairs.empty()) {
        move_apart(pairs, by_walls);
      } else if (!gaps.empty()) {
        widen(gaps);
      } else if (!uneven.empty()) {
        even_out(uneven);
      } else if (excess_m > 0.0) {
        positions_m_ = within_bound(garment_, settings_.bounded, positions_m_);
      } else {
        break;
      }
    }
    if (std::get<0>(least_) < best.pairs_left || (best.pairs_left == 0 && !shape_.empty())) {
      best.pairs_left = std::get<0>(least_);
      best.positions_m = shape_;
    }
  }

 private:
  bool keep_least(const Flaws& flaws) {
    const bool is_less = flaws < least_;
    if (is_less) {
      least_ = flaws;
      shape_ = positions_m_;
    }
    return is_less;
  }

  std::vector<Gap> narrow_gaps() const {
    return find_gaps(garment_, least_gap * settings_.distance_m, least_joined_gap_m, positions_m_);
  }

  void widen(const std::vector<Gap>& gaps) {
    Moves asked(positions_m_.size());
    for (const Gap& gap : gaps) {
      const Vec3 half_m = 0.5 * (wider_gap * settings_.distance_m - gap.width_m) * gap.apart;
      for (std::size_t k = 0; k < gap.vertices.size(); ++k) {
        asked.add(gap.vertices[k], std::copysign(1.0, gap.weights[k]) * half_m, std::abs(gap.weights[k]));
      }
    }
    apply(spread(garment_.adjacency, asked));
  }

  /// The corners of triangles that are flat, and those beside edges at which the cloth is folded back.
  std::vector<Index> uneven_vertices() const {
    const std::vector<Triangle>& triangles = garment_.mesh.triangles;
    std::vector<char> is_uneven(positions_m_.size(), 0);
    const auto mark = [&](const Triangle& t) {
      for (const Index v : t) is_uneven[v] = 1;
    };
    std::vector<Vec3> fronts;
    for (const Triangle& t : triangles) {
      const auto [a, b, c] = corners_of(t, positions_m_);
      const Vec3 area = glm::cross(b - a, c - a);
      const double longest_m = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
      if (glm::length(area) < flat * longest_m * longest_m) mark(t);
      fronts.push_back(front(t));
    }
    for (std::size_t e = 0; e < garment_.adjacency.edges.size(); ++e) {
      const std::span<const Index> around = garment_.adjacency.edge_triangles[e];
      if (around.size() == 2 && glm::dot(fronts[around[0]], fronts[around[1]]) < folded_back) {
        mark(triangles[around[0]]);
        mark(triangles[around[1]]);
      }
    }
    std::vector<Index> vertices;
    for (Index v = 0; v < is_uneven.size(); ++v) {
      if (is_uneven[v] != 0) vertices.push_back(v);
    }
    return vertices;
  }

  /// Half of the way to the middle between their neighbours, at a border those along it.
  void even_out(const std::vector<Index>& vertices) {
    const std::vector<Vec3> before_m = positions_m_;
    for (const Index v : vertices) {
      std::array<Vec3, 2> sums{Vec3(0.0), Vec3(0.0)};
      std::array<double, 2> counts{};
      for (const Index e : garment_.adjacency.vertex_edges[v]) {
        const std::size_t kind = garment_.adjacency.edge_triangles[e].size() == 1 ? 1 : 0;
        sums[kind] += before_m[other_end(garment_.adjacency.edges[e], v)];
        counts[kind] += 1.0;
      }
      const std::size_t kind = counts[1] > 0.0 ? 1 : 0;
      positions_m_[v] = 0.5 * (before_m[v] + sums[kind] / counts[kind]);
    }
  }

  void move_apart(const std::vector<TrianglePair>& pairs, bool by_walls) {
    Contours contours = find_contours(garment_, pairs, positions_m_);
    if (by_walls) take_sides_of_walls(contours.piercings);
    Moves asked(positions_m_.size());
    const std::vector<Piercing>& all = contours.piercings;
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
      std::size_t known = 0;
      for (; end < all.size() && all[end].contour == all[begin].contour; ++end) {
        known += all[end].wrong != WrongEnd::unknown ? 1 : 0;
      }
      const bool is_known = 4 * known >= end - begin;
      for (const Piercing& p : std::span(all).subspan(begin, end - begin)) {
        if (p.wrong != WrongEnd::unknown) {
          move_back(p, asked);
        } else if (!is_known) {
          shorten_contour(p, asked);
        }
      }
    }
    for (const TrianglePair& pair : contours.touching) part(pair, asked);
    apply(spread(garment_.adjacency, asked));
  }

  /// The wrong end goes back through the triangle, and this half of the way towards it.
  void move_back(const Piercing& p, Moves& asked) const {
    const Edge& edge = garment_.adjacency.edges[p.edge];
    const bool is_first = p.wrong == WrongEnd::first;
    const Vec3 along = positions_m_[edge[1]] - positions_m_[edge[0]];
    const double depth_m = std::abs(glm::dot(p.normal, along)) * (is_first ? p.along : 1.0 - p.along);
    const double way_m = std::min(depth_m + settings_.distance_m, largest_step_edges * edge_m_);
    const Vec3 half_m = (is_first ? -0.5 : 0.5) * way_m * p.normal;
    asked.add(edge[is_first ? 0 : 1], half_m, 1.0);
    asked.add(garment_.mesh.triangles[p.triangle], -half_m, p.weights);
  }

  /// Moves the edge against the triangle along the gradient of the contour's length. Where the edge E goes
  /// through, lines R begin, of length 1, along which the triangles beside it cross that triangle, whose
  /// normal is N: G = sum of R - 2 (E R) / (E N) N (Volino and Magnenat-Thalmann 2006).
  void shorten_contour(const Piercing& p, Moves& asked) const {
    const Edge& edge = garment_.adjacency.edges[p.edge];
    const Vec3& from = positions_m_[edge[0]];
    const Vec3 along = glm::normalize(positions_m_[edge[1]] - from);
    const double cosine =
        std::copysign(std::max(std::abs(glm::dot(along, p.normal)), least_cosine), glm::dot(along, p.normal));
    Vec3 gradient(0.0);
    for (const Index s : garment_.adjacency.edge_triangles[p.edge]) {
      const auto [a, b, c] = corners_of(garment_.mesh.triangles[s], positions_m_);
      const Vec3 line = glm::cross(glm::cross(b - a, c - a), p.normal);
      const Vec3 inwards = (a + b + c) / 3.0 - from;
      const double side = glm::dot(line, inwards - glm::dot(inwards, along) * along);
      if (side != 0.0) {
        const Vec3 direction = std::copysign(1.0, side) * glm::normalize(line);
        gradient += direction - 2.0 * glm::dot(direction, along) / cosine * p.normal;
      }
    }
    const double step_m = 0.5 * largest_blind_step_edges * edge_m_;
    const Vec3 half_m = step_m / std::sqrt(1.0 + glm::dot(gradient, gradient)) * gradient;
    asked.add(edge[0], half_m, 1.0 - p.along);
    asked.add(edge[1], half_m, p.along);
    asked.add(garment_.mesh.triangles[p.triangle], -half_m, p.weights);
  }

  /// Layers that lie in each other: the backs of walls face each other, and of others the one with the lower
  /// indices is in front.
  void part(const TrianglePair& pair, Moves& asked) const {
    const Triangle& s = garment_.mesh.triangles[pair[0]];
    const Triangle& t = garment_.mesh.triangles[pair[1]];
    const Vec3 front_of_s = front(s), front_of_t = front(t);
    const Vec3 apart = glm::dot(front_of_s, front_of_t) < 0.0 ? front_of_s - front_of_t : front_of_s + front_of_t;
    const Vec3 half_m = 0.25 * settings_.distance_m * apart;
    asked.add(s, half_m, Vec3(1.0));
    asked.add(t, -half_m, Vec3(1.0));
  }

  Vec3 front(const Triangle& t) const {
    const Vec3 area = doubled_area_vector(positions_m_, t);
    const double size = glm::length(area);
    return size > 0.0 ? area / size : area;
  }

  void apply(const std::vector<Vec3>& moves_m) {
    const double most_m = settings_.largest_move_edges * edge_m_;
    for (std::size_t v = 0; v < positions_m_.size(); ++v) {
      const Vec3 moved_m = positions_m_[v] + moves_m[v] - start_m_[v];
      const double length_m = glm::length(moved_m);
      positions_m_[v] = length_m > most_m ? start_m_[v] + most_m / length_m * moved_m : positions_m_[v] + moves_m[v];
    }
    for (int sweep = 0; sweep < shortening_sweeps; ++sweep) {
      shorten_once(garment_, free_, settings_.bounded, positions_m_);
    }
  }

  const Garment& garment_;
  const UntangleSettings& settings_;
  Pins free_;  ///< none
  std::span<const Vec3> start_m_;
  std::vector<Vec3> positions_m_;
  double edge_m_;
  Flaws least_ = {std::numeric_limits<std::size_t>::max(), 0.0, 0, 0};
  std::vector<Vec3> shape_;  ///< with the least
};

}  // namespace

Untangled untangle(const Garment& garment, std::vector<Vec3> start_m, const UntangleSettings& settings,
                   const FindCrossings& find_crossings) {
  const std::vector<TrianglePair> pairs = find_crossings(start_m);
  Untangled best = {start_m, pairs.size(), pairs.size()};
  if (pairs.empty() && !settings.is_cut_anew) return best;
  const bool walls = are_walls(find_contours(garment, pairs, start_m).piercings);
  Attempt(garment, settings, start_m).run(find_crossings, walls, best);
  if (best.pairs_left > 0) Attempt(garment, settings, start_m).run(find_crossings, !walls, best);
  // A run that keeps the bound begins within it. The way there may be longer than what was won.
  if (!settings.is_cut_anew && largest_excess_m(garment, settings.bounded, best.positions_m) > 0.0) {
    best.positions_m = within_bound(garment, settings.bounded, best.positions_m);
    best.pairs_left = find_crossings(best.positions_m).size();
  }
  if (best.pairs_left > 0 && best.pairs_left >= pairs.size()) return {start_m, pairs.size(), pairs.size()};
  for (std::size_t v = 0; v < start_m.size(); ++v) {
    best.largest_move_m = std::max(best.largest_move_m, glm::distance(best.positions_m[v], start_m[v]));
  }
  return best;
}

}  // namespace taut::sim
