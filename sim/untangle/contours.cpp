#include "sim/untangle/contours.hpp"

#include "sim/mesh/extent.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/solvers/bounded/contact/near_pairs.hpp"

namespace taut::sim {
namespace {

/// Cosine between the normals of surfaces of which one runs along the other and faces the other way.
constexpr double opposed = -0.7;
/// The least length of the mean of the ways out of a part, each of length 1.
constexpr double agreement = 0.5;

bool has_corner(const Triangle& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }

Index edge_between(const Adjacency& adjacency, Index a, Index b) {
  const Edge edge = {std::min(a, b), std::max(a, b)};
  return static_cast<Index>(std::lower_bound(adjacency.edges.begin(), adjacency.edges.end(), edge) -
                            adjacency.edges.begin());
}

Vec3 normal_of(const std::array<Vec3, 3>& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

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
  found.normal = glm::normalize(found.first_is_in_front ? area : -area);
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
      : garment_(garment),
        part_of_(garment.mesh.positions.size(), 0),
        blocked_by_(garment.adjacency.edges.size(), 0),
        sizes_(1, part_of_.size()) {}

  void begin(std::span<const Piercing> contour) {
    ++contour_;
    first_part_ = static_cast<Index>(sizes_.size());
    for (const Piercing& p : contour) blocked_by_[p.edge] = contour_;
  }

  /// The part that the vertex belongs to; parts of more than half of all vertices are one, the first of all.
  Index part_with(Index vertex) {
    if (part_of_[vertex] < first_part_) fill(vertex);
    return is_large(part_of_[vertex]) ? 0 : part_of_[vertex];
  }
  /// The number of vertices of a part.
  std::size_t size(Index part) const { return sizes_[part]; }

 private:
  bool is_large(Index part) const { return 2 * sizes_[part] > part_of_.size(); }

  // Ends as soon as it is known to be large, and where it meets one that is.
  void fill(Index vertex) {
    const auto part = static_cast<Index>(sizes_.size());
    sizes_.push_back(1);
    part_of_[vertex] = part;
    queue_.assign(1, vertex);
    for (std::size_t next = 0; next < queue_.size() && !is_large(part); ++next) {
      for (const Index e : garment_.adjacency.vertex_edges[queue_[next]]) {
        const Index other = other_end(garment_.adjacency.edges[e], queue_[next]);
        if (blocked_by_[e] == contour_ || part_of_[other] == part) continue;
        if (part_of_[other] >= first_part_) {
          sizes_[part] = sizes_[part_of_[other]];
          break;
        }
        part_of_[other] = part;
        ++sizes_[part];
        queue_.push_back(other);
      }
    }
  }

  const Garment& garment_;
  std::vector<Index> part_of_;
  std::vector<Index> blocked_by_;
  std::vector<std::size_t> sizes_;  ///< of parts, by their numbers
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

bool are_joined(const Adjacency& adjacency, Index v, Index w) {
  const std::span<const Index> edges = adjacency.vertex_edges[v];
  return std::any_of(edges.begin(), edges.end(), [&](Index e) { return other_end(adjacency.edges[e], v) == w; });
}

bool are_joined(const Adjacency& adjacency, const NearPair& pair) {
  for (std::size_t i = 0; i < pair.first_count; ++i) {
    for (std::size_t j = pair.first_count; j < 4; ++j) {
      if (are_joined(adjacency, pair.rows[i], pair.rows[j])) return true;
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
  gap.apart = gap.width_m > 0.0 ? gap.apart / gap.width_m : gap.apart;
  return gap;
}

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

}  // namespace taut::sim
