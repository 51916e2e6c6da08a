#include "sim/untangle/untangle.hpp"

#include "sim/mesh/extent.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/pins.hpp"
#include "sim/solvers/bounded/contact/near_pairs.hpp"
#include "sim/solvers/bounded/within_bound.hpp"

namespace taut::sim {
namespace {

/// Largest cosine between the normals of surfaces that are nearly parallel and face opposite ways.
constexpr double max_opposed_cosine = -0.7;
/// Smallest length of the mean unit direction out of a cut-off part whose triangles agree.
constexpr double min_exit_agreement = 0.5;

bool has_corner(const Triangle& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }

Vec3 area_normal(const std::array<Vec3, 3>& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

/// Returns the unit vector; 0 if the squares of its coordinates vanish, as in cloth that was moved by 1e-320 m.
Vec3 unit_direction(const Vec3& v) { return glm::dot(v, v) > 0.0 ? glm::normalize(v) : Vec3(0.0); }

/// Returns the point where the segment pierces the triangle; empty if it does not.
std::optional<Piercing> find_piercing(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& t) {
  const Vec3 area = area_normal(t);
  const double before = glm::dot(area, from - t[0]), behind = glm::dot(area, to - t[0]);
  if ((before > 0.0) == (behind > 0.0) || before == behind) return std::nullopt;
  Piercing piercing;
  for (int k = 0; k < 3; ++k) {
    const Vec3& a = t[(k + 1) % 3];
    const Vec3& b = t[(k + 2) % 3];
    piercing.weights[k] = glm::dot(to - from, glm::cross(a - from, b - from));
  }
  const double sum = piercing.weights.x + piercing.weights.y + piercing.weights.z;
  piercing.weights /= sum;
  if (!(piercing.weights.x >= 0.0 && piercing.weights.y >= 0.0 && piercing.weights.z >= 0.0)) return std::nullopt;
  piercing.along = before / (before - behind);
  piercing.first_is_in_front = before > 0.0;
  piercing.normal = unit_direction(piercing.first_is_in_front ? area : -area);
  return piercing;
}

bool faces_the_other_way(const Garment& garment, const Piercing& piercing, std::span<const Vec3> positions_m) {
  Vec3 along_edge(0.0);
  for (const Index s : garment.adjacency.edge_triangles[piercing.edge]) {
    along_edge += area_normal(corner_positions(garment.mesh.triangles[s], positions_m));
  }
  const Vec3 front = piercing.first_is_in_front ? piercing.normal : -piercing.normal;
  return glm::dot(along_edge, front) < max_opposed_cosine * glm::length(along_edge);
}

/// Appends the piercings of one pair; its number is their first contour number.
void add_piercings(const Garment& garment, const Triangle& edges_of, Index triangle, Index pair,
                   std::span<const Vec3> positions_m, std::vector<Piercing>& all) {
  const Triangle& t = garment.mesh.triangles[triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [from, to] = std::minmax(edges_of[k], edges_of[(k + 1) % 3]);
    if (has_corner(t, from) || has_corner(t, to)) continue;
    if (auto piercing = find_piercing(positions_m[from], positions_m[to], corner_positions(t, positions_m))) {
      piercing->edge = edge_between(garment.adjacency, from, to);
      piercing->triangle = triangle;
      piercing->contour = pair;
      piercing->is_opposed = faces_the_other_way(garment, *piercing, positions_m);
      all.push_back(*piercing);
    }
  }
}

/// Parts into which one contour divides the cloth.
class CutParts {
 public:
  explicit CutParts(const Garment& garment)
      : garment_(garment), part_of_(garment.mesh.positions.size(), 0), blocked_by_(garment.adjacency.edges.size(), 0) {}

  void begin(std::span<const Piercing> contour) {
    ++contour_;
    first_part_ = static_cast<Index>(sizes_.size());
    for (const Piercing& p : contour) blocked_by_[p.edge] = contour_;
  }

  /// Returns the part of the vertex.
  Index part_with(Index vertex) {
    if (part_of_[vertex] < first_part_) fill(vertex);
    return part_of_[vertex];
  }
  /// Returns the number of vertices of a part.
  std::size_t size(Index part) const { return sizes_[part]; }

 private:
  void fill(Index vertex) {
    const auto part = static_cast<Index>(sizes_.size());
    part_of_[vertex] = part;
    queue_.assign(1, vertex);
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      for (const Index e : garment_.adjacency.vertex_edges[queue_[next]]) {
        const Index other = other_end(garment_.adjacency.edges[e], queue_[next]);
        if (blocked_by_[e] == contour_ || part_of_[other] == part) continue;
        part_of_[other] = part;
        queue_.push_back(other);
      }
    }
    sizes_.push_back(queue_.size());
  }

  const Garment& garment_;
  std::vector<Index> part_of_;
  std::vector<Index> blocked_by_;
  std::vector<std::size_t> sizes_ = {0};  ///< vertex counts of the parts, numbered from 1
  std::vector<Index> queue_;
  Index contour_ = 0;
  Index first_part_ = 1;
};

WrongEnd in_front(const Piercing& p) { return p.first_is_in_front ? WrongEnd::first : WrongEnd::second; }

struct ExitDirection {
  Vec3 sum{0.0};
  double count = 0.0;

  bool is_clear() const { return glm::length(sum) >= min_exit_agreement * count; }
};

void find_wrong_ends(const Garment& garment, std::span<Piercing> contour, CutParts& parts) {
  parts.begin(contour);
  std::vector<Index> cut_off(contour.size());
  std::map<Index, ExitDirection> ways;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Edge& edge = garment.adjacency.edges[contour[i].edge];
    const Index first = parts.part_with(edge[0]), second = parts.part_with(edge[1]);
    if (first != second) {
      const bool is_first = parts.size(first) < parts.size(second);
      contour[i].wrong = is_first ? WrongEnd::first : WrongEnd::second;
      cut_off[i] = is_first ? first : second;
      ExitDirection& way = ways[cut_off[i]];
      way.sum += is_first ? -contour[i].normal : contour[i].normal;
      ++way.count;
    }
  }
  for (std::size_t i = 0; i < contour.size(); ++i) {
    if (contour[i].wrong != WrongEnd::unknown && !ways[cut_off[i]].is_clear()) {
      contour[i].wrong = WrongEnd::unknown;
    }
  }
}

/// Joins the contours of pairs that share a piercing: the line in which two triangles cross ends in two piercings, and
/// most of these also belong to an adjacent pair.
void join_contours(std::size_t pairs, std::vector<Piercing>& all) {
  std::sort(all.begin(), all.end(), [](const Piercing& a, const Piercing& b) {
    return std::tie(a.edge, a.triangle, a.contour) < std::tie(b.edge, b.triangle, b.contour);
  });
  const auto are_same = [](const Piercing& a, const Piercing& b) {
    return a.edge == b.edge && a.triangle == b.triangle;
  };
  Groups contours(pairs);
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (are_same(all[i - 1], all[i])) contours.join(all[i - 1].contour, all[i].contour);
  }
  all.erase(std::unique(all.begin(), all.end(), are_same), all.end());
  for (Piercing& p : all) p.contour = contours.find(p.contour);
  std::stable_sort(all.begin(), all.end(), [](const Piercing& a, const Piercing& b) { return a.contour < b.contour; });
}

using namespace bounded;

bool are_joined(const Adjacency& adjacency, const NearPair& pair) {
  for (std::size_t i = 0; i < pair.first_count; ++i) {
    for (std::size_t j = pair.first_count; j < 4; ++j) {
      const auto [low, high] = std::minmax(pair.rows[i], pair.rows[j]);
      if (std::binary_search(adjacency.edges.begin(), adjacency.edges.end(), Edge{low, high})) return true;
    }
  }
  return false;
}

/// Measures a pair: the closest points in single precision, their distance in double precision.
Gap measure_gap(const NearPair& pair, const Vec3& middle, std::span<const Vec3> positions_m) {
  std::array<glm::vec3, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) corners[k] = glm::vec3(positions_m[pair.rows[k]] - middle);
  const ClosestWeights weights = closest_weights(pair, corners);
  Gap gap{.vertices = pair.rows};
  for (std::size_t k = 0; k < 4; ++k) {
    gap.weights[k] = k < pair.first_count ? weights[k] : -weights[k];
    gap.apart += gap.weights[k] * (positions_m[pair.rows[k]] - middle);
  }
  gap.width_m = glm::length(gap.apart);
  gap.apart = unit_or_zero(gap.apart);
  return gap;
}

/// Largest motion per round, in mean edge lengths.
constexpr double max_step_edges = 0.5;
/// Largest motion per round if no end is known to be wrong. With smaller steps, long straight contours do not shorten.
constexpr double max_blind_step_edges = 4.0;
/// Smallest cosine between an edge and the normal of the triangle that it pierces; smaller ones are raised to it.
constexpr double min_cosine = 0.1;
/// Rings of neighbours that follow a moved vertex, the weight of each neighbour, and the weight of staying in place.
constexpr int rings = 24;
constexpr double pull_of_neighbours = 0.25;
constexpr double pull_of_place = 0.005;
/// Sweeps over stretched springs and triangles after each round.
constexpr int shortening_sweeps = 10;
/// Narrowest accepted gap and the width to which narrower ones grow, as fractions of the distance.
constexpr double min_gap_ratio = 0.5;
constexpr double widened_gap_ratio = 1.0;
/// Narrowest accepted gap between primitives joined by an edge, in m. Contact would leave out primitives nearer at
/// rest, as if they touched.
constexpr double min_joined_gap_m = 1e-5;
/// Height over longest side below which a triangle is flat, and the cosine between the normals at an edge below which
/// the cloth is folded back.
constexpr double min_height_ratio = 0.2;
constexpr double max_fold_cosine = -0.9;
/// Rounds without improvement after which untangling ends.
constexpr int max_idle_rounds = 60;

/// Requested motions; each vertex takes the weighted mean of its requests.
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

/// Returns the requested motions spread over neighbours: a field in which each vertex is drawn to its requests, to its
/// neighbours and to its place.
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

/// Returns a near shape within the bound, without contact. Sweeps converge slowly where springs pull against each
/// other.
std::vector<Vec3> within_bound(const Garment& garment, const BoundedSettings& settings, std::vector<Vec3> positions_m) {
  const Pins none = make_pins(garment, {});
  State state = make_state(garment);
  state.current = state.previous = std::move(positions_m);
  move_within_bound(garment, none, settings, state);
  std::ignore = keeps_bound_in_double(garment, none, settings, state.current);
  return state.current;
}

/// Flaws of a shape: the number of crossing pairs, the excess over the bound in m, the number of narrow gaps, and the
/// number of vertices to even out.
using Flaws = std::tuple<std::size_t, double, std::size_t, std::size_t>;

/// One attempt at untangling.
class UntangleAttempt {
 public:
  UntangleAttempt(const Garment& garment, const UntangleSettings& settings, std::span<const Vec3> start_m)
      : garment_(garment),
        settings_(settings),
        free_(make_pins(garment, {})),
        start_m_(start_m),
        positions_m_(start_m.begin(), start_m.end()),
        edge_m_(mean_edge_m(garment.springs)) {}

  /// Untangles, and updates `best` if fewer pairs remain.
  void run(const FindCrossings& find_crossings, bool by_walls, UntangleResult& best) {
    int in_vain = 0;
    for (int round = 0; round < settings_.max_rounds && in_vain < max_idle_rounds; ++round) {
      const std::vector<TrianglePair> pairs = find_crossings(positions_m_);
      best.pairs_found += pairs.size();
      if (best.pairs_found > settings_.max_pairs) break;
      const std::vector<Gap> gaps = pairs.empty() ? narrow_gaps() : std::vector<Gap>{};
      const std::vector<Index> uneven =
          pairs.empty() && settings_.is_cut_anew ? uneven_vertices() : std::vector<Index>{};
      const double excess_m = settings_.is_cut_anew ? 0.0 : max_excess_m(garment_, settings_.bounded, positions_m_);
      in_vain = keep_if_better({pairs.size(), excess_m, gaps.size(), uneven.size()}) ? 0 : in_vain + 1;
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
    if (std::get<0>(best_flaws_) < best.pairs_left || (best.pairs_left == 0 && !best_shape_m_.empty())) {
      best.pairs_left = std::get<0>(best_flaws_);
      best.positions_m = best_shape_m_;
    }
  }

 private:
  bool keep_if_better(const Flaws& flaws) {
    const bool is_less = flaws < best_flaws_;
    if (is_less) {
      best_flaws_ = flaws;
      best_shape_m_ = positions_m_;
    }
    return is_less;
  }

  std::vector<Gap> narrow_gaps() const {
    return find_gaps(garment_, min_gap_ratio * settings_.distance_m, min_joined_gap_m, positions_m_);
  }

  void widen(const std::vector<Gap>& gaps) {
    Moves asked(positions_m_.size());
    for (const Gap& gap : gaps) {
      const Vec3 half_m = 0.5 * (widened_gap_ratio * settings_.distance_m - gap.width_m) * gap.apart;
      for (std::size_t k = 0; k < gap.vertices.size(); ++k) {
        asked.add(gap.vertices[k], std::copysign(1.0, gap.weights[k]) * half_m, std::abs(gap.weights[k]));
      }
    }
    apply(spread(garment_.adjacency, asked));
  }

  /// Returns the corners of flat triangles and of triangles at folded-back edges.
  std::vector<Index> uneven_vertices() const {
    const std::vector<Triangle>& triangles = garment_.mesh.triangles;
    std::vector<char> is_uneven(positions_m_.size(), 0);
    const auto mark = [&](const Triangle& t) {
      for (const Index v : t) is_uneven[v] = 1;
    };
    std::vector<Vec3> fronts;
    for (const Triangle& t : triangles) {
      const auto [a, b, c] = corner_positions(t, positions_m_);
      const Vec3 area = glm::cross(b - a, c - a);
      const double max_length_m = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
      if (glm::length(area) < min_height_ratio * max_length_m * max_length_m) mark(t);
      fronts.push_back(front(t));
    }
    for (std::size_t e = 0; e < garment_.adjacency.edges.size(); ++e) {
      const std::span<const Index> around = garment_.adjacency.edge_triangles[e];
      if (around.size() == 2 && glm::dot(fronts[around[0]], fronts[around[1]]) < max_fold_cosine) {
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

  /// Moves vertices halfway to the mean of their neighbours; at a border, of the neighbours along it.
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
    for (const TrianglePair& pair : contours.touching) separate_touching(pair, asked);
    apply(spread(garment_.adjacency, asked));
  }

  /// Requests that the wrong end and the triangle each move half of the way back through each other.
  void move_back(const Piercing& p, Moves& asked) const {
    const Edge& edge = garment_.adjacency.edges[p.edge];
    const bool is_first = p.wrong == WrongEnd::first;
    const Vec3 along = positions_m_[edge[1]] - positions_m_[edge[0]];
    const double depth_m = std::abs(glm::dot(p.normal, along)) * (is_first ? p.along : 1.0 - p.along);
    const double way_m = std::min(depth_m + settings_.distance_m, max_step_edges * edge_m_);
    const Vec3 half_m = (is_first ? -0.5 : 0.5) * way_m * p.normal;
    asked.add(edge[is_first ? 0 : 1], half_m, 1.0);
    asked.add(garment_.mesh.triangles[p.triangle], -half_m, p.weights);
  }

  /// Requests a motion of the edge against the triangle along the gradient of the contour's length. At the piercing,
  /// unit lines R begin along which the triangles beside the edge E cross the pierced triangle with normal N: G = sum
  /// of R - 2 (E R) / (E N) N (Volino and Magnenat-Thalmann 2006).
  void shorten_contour(const Piercing& p, Moves& asked) const {
    const Edge& edge = garment_.adjacency.edges[p.edge];
    const Vec3& from = positions_m_[edge[0]];
    const Vec3 along = unit_direction(positions_m_[edge[1]] - from);
    const double cosine =
        std::copysign(std::max(std::abs(glm::dot(along, p.normal)), min_cosine), glm::dot(along, p.normal));
    Vec3 gradient(0.0);
    for (const Index s : garment_.adjacency.edge_triangles[p.edge]) {
      const auto [a, b, c] = corner_positions(garment_.mesh.triangles[s], positions_m_);
      const Vec3 line = glm::cross(glm::cross(b - a, c - a), p.normal);
      const Vec3 inwards = (a + b + c) / 3.0 - from;
      const double side = glm::dot(line, inwards - glm::dot(inwards, along) * along);
      if (side != 0.0) {
        const Vec3 direction = std::copysign(1.0, side) * unit_direction(line);
        gradient += direction - 2.0 * glm::dot(direction, along) / cosine * p.normal;
      }
    }
    const double step_m = 0.5 * max_blind_step_edges * edge_m_;
    const Vec3 half_m = step_m / std::sqrt(1.0 + glm::dot(gradient, gradient)) * gradient;
    asked.add(edge[0], half_m, 1.0 - p.along);
    asked.add(edge[1], half_m, p.along);
    asked.add(garment_.mesh.triangles[p.triangle], -half_m, p.weights);
  }

  /// Requests that touching layers separate. Opposed walls have their backs towards each other; of other layers the one
  /// with the lower index is in front.
  void separate_touching(const TrianglePair& pair, Moves& asked) const {
    const Triangle& s = garment_.mesh.triangles[pair[0]];
    const Triangle& t = garment_.mesh.triangles[pair[1]];
    const Vec3 front_of_s = front(s), front_of_t = front(t);
    const Vec3 apart = glm::dot(front_of_s, front_of_t) < 0.0 ? front_of_s - front_of_t : front_of_s + front_of_t;
    const Vec3 half_m = 0.25 * settings_.distance_m * apart;
    asked.add(s, half_m, Vec3(1.0));
    asked.add(t, -half_m, Vec3(1.0));
  }

  Vec3 front(const Triangle& t) const { return unit_or_zero(doubled_area_vector(positions_m_, t)); }

  void apply(const std::vector<Vec3>& moves_m) {
    const double max_move_m = settings_.max_move_edges * edge_m_;
    for (std::size_t v = 0; v < positions_m_.size(); ++v) {
      const Vec3 moved_m = positions_m_[v] + moves_m[v] - start_m_[v];
      const double length_m = glm::length(moved_m);
      positions_m_[v] =
          length_m > max_move_m ? start_m_[v] + max_move_m / length_m * moved_m : positions_m_[v] + moves_m[v];
    }
    for (int sweep = 0; sweep < shortening_sweeps; ++sweep) {
      shorten_once(garment_, free_, settings_.bounded, positions_m_);
    }
  }

  const Garment& garment_;
  const UntangleSettings& settings_;
  Pins free_;  ///< empty
  std::span<const Vec3> start_m_;
  std::vector<Vec3> positions_m_;
  double edge_m_;
  Flaws best_flaws_ = {std::numeric_limits<std::size_t>::max(), 0.0, 0, 0};
  std::vector<Vec3> best_shape_m_;  ///< shape with the fewest flaws
};

}  // namespace

std::vector<Piercing> find_piercings(const Garment& garment, std::span<const TrianglePair> pairs,
                                     std::span<const Vec3> positions_m) {
  std::vector<Piercing> all;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const auto [s, t] = pairs[p];
    add_piercings(garment, garment.mesh.triangles[s], t, static_cast<Index>(p), positions_m, all);
    add_piercings(garment, garment.mesh.triangles[t], s, static_cast<Index>(p), positions_m, all);
  }
  return all;
}

Contours find_contours(const Garment& garment, std::span<const TrianglePair> pairs, std::span<const Vec3> positions_m) {
  assert(positions_m.size() == garment.mesh.positions.size());
  Contours piercing;
  std::vector<Piercing>& all = piercing.piercings;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const auto [s, t] = pairs[p];
    const std::size_t before = all.size();
    add_piercings(garment, garment.mesh.triangles[s], t, static_cast<Index>(p), positions_m, all);
    add_piercings(garment, garment.mesh.triangles[t], s, static_cast<Index>(p), positions_m, all);
    if (all.size() == before) piercing.touching.push_back(pairs[p]);
  }
  join_contours(pairs.size(), all);
  CutParts parts(garment);
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    while (end < all.size() && all[end].contour == all[begin].contour) ++end;
    find_wrong_ends(garment, std::span(all).subspan(begin, end - begin), parts);
  }
  return piercing;
}

bool are_walls(std::span<const Piercing> piercings) {
  int in_favour = 0;
  for (const Piercing& p : piercings) {
    if (p.is_opposed && p.wrong != WrongEnd::unknown) in_favour += p.wrong == in_front(p) ? 1 : -1;
  }
  return in_favour > 0;
}

void take_sides_of_walls(std::span<Piercing> piercings) {
  for (Piercing& p : piercings) p.wrong = p.is_opposed ? in_front(p) : p.wrong;
}

std::vector<Gap> find_gaps(const Garment& garment, double width_m, double joined_width_m,
                           std::span<const Vec3> positions_m) {
  assert(positions_m.size() == garment.mesh.positions.size());
  assert(joined_width_m >= 0.0);
  const Extent extent = compute_extent(positions_m);
  const Vec3 middle = extent.middle();
  Float4Array rows;
  for (const Vec3& position_m : positions_m) rows.push_back(to_float4(position_m - middle));
  const std::vector<float> radii(rows.size(), static_cast<float>(0.5 * width_m));
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  NearPairs near(make_contact_mesh(garment.mesh.triangles, {}), true, positions_m);
  std::vector<Gap> gaps;
  for (const NearPair& pair : near.find(rows, Float4Array(rows.size()), radii, kernels)) {
    const double wide_m = are_joined(garment.adjacency, pair) ? joined_width_m : width_m;
    const Gap gap = measure_gap(pair, middle, positions_m);
    if (gap.width_m > 0.0 && gap.width_m < wide_m) gaps.push_back(gap);
  }
  return gaps;
}

UntangleResult untangle(const Garment& garment, std::vector<Vec3> start_m, const UntangleSettings& settings,
                        const FindCrossings& find_crossings) {
  const std::vector<TrianglePair> pairs = find_crossings(start_m);
  UntangleResult as_it_was = {{pairs.size(), pairs.size(), pairs.size()}, start_m};
  as_it_was.is_given_up = pairs.size() > settings.max_pairs;
  if (as_it_was.is_given_up) return as_it_was;
  UntangleResult best = as_it_was;
  if (pairs.empty() && !settings.is_cut_anew) return best;
  const bool walls = are_walls(find_contours(garment, pairs, start_m).piercings);
  UntangleAttempt(garment, settings, start_m).run(find_crossings, walls, best);
  if (best.pairs_left > 0 && best.pairs_found <= settings.max_pairs)
    UntangleAttempt(garment, settings, start_m).run(find_crossings, !walls, best);
  as_it_was.is_given_up = best.is_given_up = best.pairs_found > settings.max_pairs;
  // A run that keeps the bound begins within it. Moving there may cost more crossings than untangling won.
  if (!settings.is_cut_anew && max_excess_m(garment, settings.bounded, best.positions_m) > 0.0) {
    best.positions_m = within_bound(garment, settings.bounded, best.positions_m);
    best.pairs_left = find_crossings(best.positions_m).size();
  }
  if (best.pairs_left > 0 && best.pairs_left >= pairs.size()) return as_it_was;
  for (std::size_t v = 0; v < start_m.size(); ++v) {
    best.max_move_m = std::max(best.max_move_m, glm::distance(best.positions_m[v], start_m[v]));
  }
  return best;
}

}  // namespace taut::sim
