#include "sim/untangle/untangle.hpp"

#include "sim/mesh/extent.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/pins.hpp"
#include "sim/solvers/bounded/contact/near_pairs.hpp"
#include "sim/solvers/bounded/within_bound.hpp"

namespace taut::sim {
namespace {

/// Cosine between the normals of surfaces of which one runs along the other and faces the other way.
constexpr double opposed = -0.7;
/// The least length of the mean of the ways out of a part, each of length 1.
constexpr double agreement = 0.5;

bool has_corner(const Triangle& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }

Vec3 normal_of(const std::array<Vec3, 3>& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

/// The vector of length 1; 0 where the squares of its coordinates vanish, as in cloth that was moved by 1e-320 m.
Vec3 direction_of(const Vec3& v) { return glm::dot(v, v) > 0.0 ? glm::normalize(v) : Vec3(0.0); }

/// Where the segment goes through the triangle; empty: nowhere.
std::optional<Piercing> piercing_of(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& t) {
  const Vec3 area = normal_of(t);
  const double before = glm::dot(area, from - t[0]), behind = glm::dot(area, to - t[0]);
  if ((before > 0.0) == (behind > 0.0) || before == behind) return std::nullopt;
  Piercing found;
  for (int k = 0; k < 3; ++k) {
    const Vec3& a = t[(k + 1) % 3];
    const Vec3& b = t[(k + 2) % 3];
    found.weights[k] = glm::dot(to - from, glm::cross(a - from, b - from));
  }
  const double sum = found.weights.x + found.weights.y + found.weights.z;
  found.weights /= sum;
  if (!(found.weights.x >= 0.0 && found.weights.y >= 0.0 && found.weights.z >= 0.0)) return std::nullopt;
  found.along = before / (before - behind);
  found.first_is_in_front = before > 0.0;
  found.normal = direction_of(found.first_is_in_front ? area : -area);
  return found;
}

bool faces_the_other_way(const Garment& garment, const Piercing& found, std::span<const Vec3> positions_m) {
  Vec3 along_edge(0.0);
  for (const Index s : garment.adjacency.edge_triangles[found.edge]) {
    along_edge += normal_of(corners_of(garment.mesh.triangles[s], positions_m));
  }
  const Vec3 front = found.first_is_in_front ? found.normal : -found.normal;
  return glm::dot(along_edge, front) < opposed * glm::length(along_edge);
}

/// Contours of one pair, by number of the pair.
void add_piercings(const Garment& garment, const Triangle& edges_of, Index triangle, Index pair,
                   std::span<const Vec3> positions_m, std::vector<Piercing>& all) {
  const Triangle& t = garment.mesh.triangles[triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [from, to] = std::minmax(edges_of[k], edges_of[(k + 1) % 3]);
    if (has_corner(t, from) || has_corner(t, to)) continue;
    if (auto found = piercing_of(positions_m[from], positions_m[to], corners_of(t, positions_m))) {
      found->edge = edge_between(garment.adjacency, from, to);
      found->triangle = triangle;
      found->contour = pair;
      found->is_opposed = faces_the_other_way(garment, *found, positions_m);
      all.push_back(*found);
    }
  }
}

/// The parts into which one contour parts the cloth.
class Parts {
 public:
  explicit Parts(const Garment& garment)
      : garment_(garment), part_of_(garment.mesh.positions.size(), 0), blocked_by_(garment.adjacency.edges.size(), 0) {}

  void begin(std::span<const Piercing> contour) {
    ++contour_;
    first_part_ = static_cast<Index>(sizes_.size());
    for (const Piercing& p : contour) blocked_by_[p.edge] = contour_;
  }

  /// The part that the vertex belongs to.
  Index part_with(Index vertex) {
    if (part_of_[vertex] < first_part_) fill(vertex);
    return part_of_[vertex];
  }
  /// The number of vertices of a part.
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
  std::vector<std::size_t> sizes_ = {0};  ///< of parts, by their numbers, from 1
  std::vector<Index> queue_;
  Index contour_ = 0;
  Index first_part_ = 1;
};

WrongEnd in_front(const Piercing& p) { return p.first_is_in_front ? WrongEnd::first : WrongEnd::second; }

struct WayOut {
  Vec3 sum{0.0};
  double count = 0.0;

  bool is_clear() const { return glm::length(sum) >= agreement * count; }
};

void find_wrong_ends(const Garment& garment, std::span<Piercing> contour, Parts& parts) {
  parts.begin(contour);
  std::vector<Index> cut_off(contour.size());
  std::map<Index, WayOut> ways;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Edge& edge = garment.adjacency.edges[contour[i].edge];
    const Index first = parts.part_with(edge[0]), second = parts.part_with(edge[1]);
    if (first != second) {
      const bool is_first = parts.size(first) < parts.size(second);
      contour[i].wrong = is_first ? WrongEnd::first : WrongEnd::second;
      cut_off[i] = is_first ? first : second;
      WayOut& way = ways[cut_off[i]];
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

/// Numbers contours by what their pairs have in common: the two ends of the line in which two triangles cross
/// are piercings of that pair, and most are of the pair beside it too.
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

/// Where they are nearest is found in single precision, and how near that is in double precision.
Gap gap_of(const NearPair& pair, const Vec3& middle, std::span<const Vec3> positions_m) {
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
      best.pairs_found += pairs.size();
      if (best.pairs_found > settings_.max_pairs) break;
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
    const Vec3 along = direction_of(positions_m_[edge[1]] - from);
    const double cosine =
        std::copysign(std::max(std::abs(glm::dot(along, p.normal)), least_cosine), glm::dot(along, p.normal));
    Vec3 gradient(0.0);
    for (const Index s : garment_.adjacency.edge_triangles[p.edge]) {
      const auto [a, b, c] = corners_of(garment_.mesh.triangles[s], positions_m_);
      const Vec3 line = glm::cross(glm::cross(b - a, c - a), p.normal);
      const Vec3 inwards = (a + b + c) / 3.0 - from;
      const double side = glm::dot(line, inwards - glm::dot(inwards, along) * along);
      if (side != 0.0) {
        const Vec3 direction = std::copysign(1.0, side) * direction_of(line);
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

  Vec3 front(const Triangle& t) const { return unit_or_zero(doubled_area_vector(positions_m_, t)); }

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

Contours find_contours(const Garment& garment, std::span<const TrianglePair> pairs, std::span<const Vec3> positions_m) {
  Contours found;
  std::vector<Piercing>& all = found.piercings;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const auto [s, t] = pairs[p];
    const std::size_t before = all.size();
    add_piercings(garment, garment.mesh.triangles[s], t, static_cast<Index>(p), positions_m, all);
    add_piercings(garment, garment.mesh.triangles[t], s, static_cast<Index>(p), positions_m, all);
    if (all.size() == before) found.touching.push_back(pairs[p]);
  }
  join_contours(pairs.size(), all);
  Parts parts(garment);
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    while (end < all.size() && all[end].contour == all[begin].contour) ++end;
    find_wrong_ends(garment, std::span(all).subspan(begin, end - begin), parts);
  }
  return found;
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
  const Extent extent = extent_of(positions_m);
  const Vec3 middle = extent.middle();
  Float4Array rows;
  for (const Vec3& position_m : positions_m) rows.push_back(float4_of(position_m - middle));
  const std::vector<float> radii(rows.size(), static_cast<float>(0.5 * width_m));
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  NearPairs near(make_contact_mesh(garment.mesh.triangles, {}), true, positions_m);
  std::vector<Gap> gaps;
  for (const NearPair& pair : near.find(rows, Float4Array(rows.size()), radii, kernels)) {
    const double wide_m = are_joined(garment.adjacency, pair) ? joined_width_m : width_m;
    const Gap gap = gap_of(pair, middle, positions_m);
    if (gap.width_m > 0.0 && gap.width_m < wide_m) gaps.push_back(gap);
  }
  return gaps;
}

Untangled untangle(const Garment& garment, std::vector<Vec3> start_m, const UntangleSettings& settings,
                   const FindCrossings& find_crossings) {
  const std::vector<TrianglePair> pairs = find_crossings(start_m);
  Untangled as_it_was = {{pairs.size(), pairs.size(), pairs.size()}, start_m};
  as_it_was.is_given_up = pairs.size() > settings.max_pairs;
  if (as_it_was.is_given_up) return as_it_was;
  Untangled best = as_it_was;
  if (pairs.empty() && !settings.is_cut_anew) return best;
  const bool walls = are_walls(find_contours(garment, pairs, start_m).piercings);
  Attempt(garment, settings, start_m).run(find_crossings, walls, best);
  if (best.pairs_left > 0 && best.pairs_found <= settings.max_pairs)
    Attempt(garment, settings, start_m).run(find_crossings, !walls, best);
  as_it_was.is_given_up = best.is_given_up = best.pairs_found > settings.max_pairs;
  // A run that keeps the bound begins within it. The way there may be longer than what was won.
  if (!settings.is_cut_anew && largest_excess_m(garment, settings.bounded, best.positions_m) > 0.0) {
    best.positions_m = within_bound(garment, settings.bounded, best.positions_m);
    best.pairs_left = find_crossings(best.positions_m).size();
  }
  if (best.pairs_left > 0 && best.pairs_left >= pairs.size()) return as_it_was;
  for (std::size_t v = 0; v < start_m.size(); ++v) {
    best.largest_move_m = std::max(best.largest_move_m, glm::distance(best.positions_m[v], start_m[v]));
  }
  return best;
}

}  // namespace taut::sim
