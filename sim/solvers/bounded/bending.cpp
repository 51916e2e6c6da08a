#include "sim/solvers/bounded/bending.hpp"

#include "sim/mesh/preconditions.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
namespace {

/// Factor for springs in all directions. They see only 3/8 of the bending energy of a cylinder: the mean of the fourth
/// power of the cosine over all directions.
constexpr double cylinder_factor = 8.0 / 3.0;
/// Factor for springs along the two directions of a grid. A cylinder bends only one of the two.
constexpr double grid_factor = 2.0;
/// Smallest squared sine of the angle between two crossing lines. Smaller values accept nearly parallel lines, whose
/// crossing is ill defined.
constexpr double min_squared_sine = 1e-3;
/// Weight of the distance from v in the choice between crossings equally far from the middle.
constexpr double distance_weight = 1e-3;

/// Closest points of two lines: the parameter s along a-b and t along v-c.
struct LineCrossing {
  double s;
  double t;
};

std::optional<LineCrossing> cross_lines(const Vec3& a, const Vec3& b, const Vec3& v, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 vc = c - v;
  const Vec3 va = a - v;
  const double ab2 = glm::dot(ab, ab);
  const double vc2 = glm::dot(vc, vc);
  const double mixed = glm::dot(ab, vc);
  const double determinant = ab2 * vc2 - mixed * mixed;
  if (!(determinant > min_squared_sine * ab2 * vc2)) return std::nullopt;
  const double from_a = glm::dot(ab, va);
  const double from_v = glm::dot(vc, va);
  return LineCrossing{(mixed * from_v - vc2 * from_a) / determinant, (ab2 * from_v - mixed * from_a) / determinant};
}

class Neighbours {
 public:
  explicit Neighbours(const Garment& garment)
      : edges_(garment.adjacency.edges), edges_at_(garment.adjacency.vertex_edges) {}

  std::vector<Index> of(Index v) const {
    std::vector<Index> neighbours;
    for (const Index e : edges_at_[v]) neighbours.push_back(other_end(edges_[e], v));
    std::sort(neighbours.begin(), neighbours.end());
    return neighbours;
  }

  std::vector<Index> common(Index a, Index b) const {
    const std::vector<Index> of_a = of(a);
    const std::vector<Index> of_b = of(b);
    std::vector<Index> both;
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(both));
    return both;
  }

 private:
  const std::vector<Edge>& edges_;
  const CompressedRows& edges_at_;
};

/// Returns the element whose crossing is nearest to the middle of the spring. It tries the lines from each common
/// neighbour v of both ends. Lines extend beyond v because at a border the spring can pass outside the cloth.
std::optional<FlexuralElement> find_element(const Edge& spring, const std::vector<Vec3>& positions,
                                            const Neighbours& neighbours) {
  const auto [a, b] = spring;
  std::optional<FlexuralElement> best;
  double best_offset = 0.5;  // within the spring
  for (const Index v : neighbours.common(a, b)) {
    for (const Index c : neighbours.of(v)) {
      if (c == a || c == b) continue;
      const auto crossing = cross_lines(positions[a], positions[b], positions[v], positions[c]);
      if (!crossing || !(std::abs(crossing->t) <= 1.0)) continue;
      const auto [s, t] = *crossing;
      const double offset = std::abs(s - 0.5) + distance_weight * std::abs(t);
      if (offset < best_offset) {
        best_offset = offset;
        const double length_m = glm::length(positions[a] - positions[b]);
        const double deflection_per_curvature = s * (1.0 - s) * length_m * length_m / 2.0;
        best = {{a, b, v, c}, {1.0 - s, s, t - 1.0, -t}, 1.0 / (deflection_per_curvature * deflection_per_curvature)};
      }
    }
  }
  return best;
}

/// Multiplies each element's stiffness by its area: the area at its vertex v, divided among the elements there.
void scale_by_area(const Garment& garment, std::vector<FlexuralElement>& elements) {
  assert(are_below(garment.mesh.triangles, garment.mesh.positions.size()));
  std::vector<double> count(garment.mesh.positions.size(), 0.0);
  for (const FlexuralElement& e : elements) count[e.vertices[2]] += 1.0;
  double covered_m2 = 0.0;
  double total_m2 = 0.0;
  for (std::size_t v = 0; v < count.size(); ++v) {
    const double area_m2 = garment.masses_kg[v] / garment.material_at(static_cast<Index>(v)).areal_density_kg_per_m2;
    total_m2 += area_m2;
    covered_m2 += count[v] > 0.0 ? area_m2 : 0.0;
  }
  const double factor = garment.mesh.quads.empty() ? cylinder_factor : grid_factor;
  for (FlexuralElement& e : elements) {
    const Index v = e.vertices[2];
    const Material& own = garment.material_at(v);
    const double area_m2 = garment.masses_kg[v] / own.areal_density_kg_per_m2;
    e.stiffness_per_rigidity *= factor * (total_m2 / covered_m2) * area_m2 / count[v];
    if (!garment.other_materials.empty()) {
      e.stiffness_per_rigidity *= own.bending_rigidity_n_m / garment.material.bending_rigidity_n_m;
    }
  }
}

constexpr Index unassigned = ~Index{0};

class Clusters {
 public:
  explicit Clusters(const Garment& garment)
      : adjacency_(garment.adjacency), cluster_of_(garment.mesh.positions.size(), unassigned) {}

  /// Puts a free vertex and up to three free neighbours into a new cluster. A vertex without free neighbours joins the
  /// smallest cluster next to it.
  void add(Index v) {
    if (cluster_of_[v] != unassigned) return;
    const Index joined = find_smallest_beside(v);
    std::vector<Index> members = {v};
    for (const Index e : adjacency_.vertex_edges[v]) {
      const Index other = other_end(adjacency_.edges[e], v);
      if (cluster_of_[other] == unassigned && members.size() < max_cluster_vertices) members.push_back(other);
    }
    const bool is_alone = members.size() == 1 && joined != unassigned;
    const Index cluster = is_alone ? joined : static_cast<Index>(sizes_.size());
    if (!is_alone) sizes_.push_back(0);
    for (const Index member : members) {
      cluster_of_[member] = cluster;
      ++sizes_[cluster];
    }
  }

  std::size_t count() const { return sizes_.size(); }
  std::vector<Index> take() { return std::move(cluster_of_); }

 private:
  Index find_smallest_beside(Index v) const {
    Index smallest = unassigned;
    for (const Index e : adjacency_.vertex_edges[v]) {
      const Index cluster = cluster_of_[other_end(adjacency_.edges[e], v)];
      if (cluster != unassigned && (smallest == unassigned || sizes_[cluster] < sizes_[smallest])) {
        smallest = cluster;
      }
    }
    return smallest;
  }

  const Adjacency& adjacency_;
  std::vector<Index> cluster_of_;
  std::vector<std::size_t> sizes_;
};

/// Returns the triangles between three clusters, each once, oriented like the first fine triangle that spans them.
std::vector<Triangle> triangles_between(const Mesh& fine, const std::vector<Index>& cluster_indices) {
  assert(cluster_indices.size() == fine.positions.size());
  std::set<std::array<Index, 3>> known;
  std::vector<Triangle> triangles;
  for (const Triangle& t : fine.triangles) {
    const Triangle coarse = {cluster_indices[t[0]], cluster_indices[t[1]], cluster_indices[t[2]]};
    std::array<Index, 3> sorted = {coarse[0], coarse[1], coarse[2]};
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] != sorted[1] && sorted[1] != sorted[2] && known.insert(sorted).second) {
      triangles.push_back(coarse);
    }
  }
  return triangles;
}

/// Iterations of the power method for the highest rate. The result is close because the highest modes are many and
/// similar.
constexpr int power_iterations = 40;

/// Returns the squared angular frequency of a single element, in 1/s^2.
double squared_rate(const FlexuralElement& e, double stiffness, const Pins& pins) {
  assert(stiffness >= 0.0);
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    sum += pins.inverse_masses_per_kg[e.vertices[k]] * e.weights[k] * e.weights[k];
  }
  return stiffness * sum;
}

struct Entry {
  Index row;
  Index column;
  double value;
};

/// Sums the entries of the same row and column. The result is sorted by row, then column.
std::vector<Entry> sum_entries(std::vector<Entry> entries) {
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.row != b.row ? a.row < b.row : a.column < b.column; });
  std::vector<Entry> sums;
  for (const Entry& e : entries) {
    if (!sums.empty() && sums.back().row == e.row && sums.back().column == e.column) {
      sums.back().value += e.value;
    } else {
      sums.push_back(e);
    }
  }
  return sums;
}

/// Bending stiffness of one level, and the rigidity left to the next.
struct LevelStiffness {
  std::vector<Entry> stiffness;     ///< K, by rows
  std::vector<double> left_shares;  ///< remaining fraction of the rigidity by vertex
};

/// Returns the stiffness of a level. `shares` is its wanted fraction of the rigidity per vertex.
LevelStiffness take_stiffness(const Garment& garment, const Pins& pins, const std::vector<Index>& solver_indices,
                              const std::vector<double>& shares, double rigidity_n_m, double max_element_rate_per_s) {
  std::vector<double> left(shares.size(), 0.0);
  std::vector<double> whole(shares.size(), 0.0);
  std::vector<Entry> entries;
  for (const FlexuralElement& e : flexural_elements(garment)) {
    const Index v = e.vertices[2];
    double k = shares[v] * rigidity_n_m * e.stiffness_per_rigidity;
    const double rate2 = squared_rate(e, k, pins);
    const double softened = rate2 > max_element_rate_per_s * max_element_rate_per_s
                                ? max_element_rate_per_s * max_element_rate_per_s / rate2
                                : 1.0;
    whole[v] += e.stiffness_per_rigidity;
    left[v] += e.stiffness_per_rigidity * (1.0 - softened);
    k *= softened;
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = 0; q < 4; ++q) {
        const double value = k * e.weights[p] * e.weights[q];
        if (value != 0.0) {
          entries.push_back({solver_indices[e.vertices[p]], solver_indices[e.vertices[q]], value});
        }
      }
    }
  }
  for (std::size_t v = 0; v < left.size(); ++v) {
    left[v] = whole[v] > 0.0 ? shares[v] * left[v] / whole[v] : 0.0;
  }
  return {sum_entries(std::move(entries)), std::move(left)};
}

/// Returns the rows of -W K.
std::vector<std::vector<MatrixEntry>> acceleration_rows(const std::vector<Entry>& stiffness,
                                                        const std::vector<double>& inverse_masses_per_kg) {
  std::vector<std::vector<MatrixEntry>> rows(inverse_masses_per_kg.size());
  for (const Entry& e : stiffness) {
    const double w = inverse_masses_per_kg[e.row];
    if (w > 0.0 && e.column != e.row) rows[e.row].push_back({e.column, -w * e.value});
  }
  return rows;
}

/// Returns, per cluster, the mass-weighted mean of the remaining fractions of its vertices.
std::vector<double> shares_of_clusters(const CoarseCloth& coarse, const std::vector<double>& left) {
  std::vector<double> shares(coarse.garment.mesh.positions.size(), 0.0);
  for (std::size_t v = 0; v < left.size(); ++v) {
    shares[coarse.cluster_indices[v]] += coarse.mass_fraction[v] * left[v];
  }
  return shares;
}

template <typename T, typename U>
std::vector<T> by_row(const std::vector<U>& by_vertex, const std::vector<Index>& vertex_indices) {
  std::vector<T> rows;
  rows.reserve(by_vertex.size());
  for (const Index v : vertex_indices) rows.push_back(static_cast<T>(by_vertex[v]));
  return rows;
}

std::vector<Index> ascending_numbers(std::size_t count) {
  std::vector<Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), Index{0});
  return numbers;
}

}  // namespace

std::vector<FlexuralElement> flexural_elements(const Garment& garment) {
  const Neighbours neighbours(garment);
  const Springs& springs = garment.springs;
  std::vector<FlexuralElement> elements;
  for (std::size_t s = springs.begin_index(SpringKind::flexural); s < springs.size(); ++s) {
    if (const auto element = find_element(springs.ends[s], garment.mesh.positions, neighbours)) {
      elements.push_back(*element);
    }
  }
  scale_by_area(garment, elements);
  return elements;
}

CoarseCloth coarsen(const Garment& fine, const std::vector<Index>& order) {
  assert(order.size() == fine.mesh.positions.size());
  Clusters clusters(fine);
  for (const Index v : order) clusters.add(v);
  std::vector<double> masses_kg(clusters.count(), 0.0);
  CoarseCloth coarse;
  coarse.cluster_indices = clusters.take();
  for (std::size_t v = 0; v < coarse.cluster_indices.size(); ++v) {
    masses_kg[coarse.cluster_indices[v]] += fine.masses_kg[v];
  }
  Mesh mesh;
  mesh.positions.resize(masses_kg.size(), Vec3(0.0));
  for (std::size_t v = 0; v < coarse.cluster_indices.size(); ++v) {
    const Index cluster = coarse.cluster_indices[v];
    const double part = masses_kg[cluster] > 0.0 ? fine.masses_kg[v] / masses_kg[cluster] : 0.0;
    coarse.mass_fraction.push_back(part);
    mesh.positions[cluster] += part * fine.mesh.positions[v];
  }
  mesh.triangles = triangles_between(fine.mesh, coarse.cluster_indices);
  coarse.garment = make_garment(std::move(mesh), {}, fine.material);
  coarse.garment.other_materials = fine.other_materials;
  if (!fine.material_indices.empty()) coarse.garment.material_indices.resize(masses_kg.size());
  for (std::size_t v = 0; v < fine.material_indices.size(); ++v) {
    coarse.garment.material_indices[coarse.cluster_indices[v]] = fine.material_indices[v];
  }
  coarse.garment.masses_kg = std::move(masses_kg);
  return coarse;
}

Bending::Bending(const Garment& garment, const Pins& pins, const Layout& layout, double rigidity_n_m,
                 double max_element_rate_per_s)
    : first_free_row_(layout.pin_count), row_count_(layout.vertex_count()) {
  assert(rigidity_n_m >= 0.0);
  assert(max_element_rate_per_s > 0.0);
  if (!(rigidity_n_m > 0.0)) return;
  const auto take = [&](const Garment& from, const Pins& level_pins, const std::vector<Index>& solver_indices,
                        const std::vector<Index>& vertex_indices, const std::vector<double>& shares) {
    const bool is_coarsest = shares.size() < max_cluster_vertices * tuning::min_clusters;
    const double rate_per_s = max_element_rate_per_s * (is_coarsest ? tuning::coarsest_rate_factor : 1.0);
    LevelStiffness taken = take_stiffness(from, level_pins, solver_indices, shares, rigidity_n_m, rate_per_s);
    const auto inverse_masses = by_row<double>(level_pins.inverse_masses_per_kg, vertex_indices);
    levels_.emplace_back();
    levels_.back().matrix = make_sliced_matrix(acceleration_rows(taken.stiffness, inverse_masses));
    return is_coarsest ? std::vector<double>(shares.size(), 0.0) : std::move(taken.left_shares);
  };

  std::vector<Index> order = layout.vertex_indices;
  std::vector<double> left = take(garment, pins, layout.solver_indices, order, std::vector<double>(row_count_, 1.0));
  CoarseCloth coarse;
  while (*std::max_element(left.begin(), left.end()) > 0.0) {
    coarse = coarsen(levels_.size() == 1 ? garment : coarse.garment, order);
    const std::vector<double> shares = shares_of_clusters(coarse, left);
    const auto cluster_indices = by_row<std::uint32_t>(coarse.cluster_indices, order);
    const auto mass_fraction = by_row<float>(coarse.mass_fraction, order);
    order = ascending_numbers(shares.size());
    left = take(coarse.garment, make_pins(coarse.garment, {}), order, order, shares);
    BendingLevel& level = levels_.back();
    level.cluster_indices = cluster_indices;
    level.mass_fraction = mass_fraction;
    level.positions.resize(shares.size() + block_size);
    level.accelerations.resize(level.positions.size());
  }
  max_rate_per_s_ = find_max_rate_per_s();
}

std::vector<double> Bending::apply_bending(const std::vector<double>& mode) const {
  std::vector<std::vector<double>> modes = {mode};
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    const BendingLevel& level = levels_[l];
    std::vector<double> coarse(level.positions.size() - block_size, 0.0);
    for (std::size_t row = 0; row < level.cluster_indices.size(); ++row) {
      coarse[level.cluster_indices[row]] += static_cast<double>(level.mass_fraction[row]) * modes.back()[row];
    }
    modes.push_back(std::move(coarse));
  }
  std::vector<double> image;
  for (std::size_t l = levels_.size(); l-- > 0;) {
    const std::size_t begin = l == 0 ? first_free_row_ : 0;
    std::vector<double> finer(modes[l].size(), 0.0);
    for (std::size_t row = begin; row < finer.size() && l + 1 < levels_.size(); ++row) {
      finer[row] = image[levels_[l + 1].cluster_indices[row]];
    }
    add_product(levels_[l].matrix, modes[l], finer);
    image = std::move(finer);
  }
  return image;
}

double Bending::find_max_rate_per_s() const {
  std::vector<double> mode(row_count_, 0.0);
  for (std::size_t row = first_free_row_; row < row_count_; ++row) mode[row] = row % 2 == 0 ? 1.0 : -0.5;
  double eigenvalue = 0.0;
  for (int iteration = 0; iteration < power_iterations; ++iteration) {
    mode = apply_bending(mode);
    double largest = 0.0;
    for (const double x : mode) largest = std::max(largest, std::abs(x));
    if (!(largest > 0.0)) break;
    eigenvalue = largest;
    for (double& x : mode) x /= largest;
  }
  return std::sqrt(eigenvalue);
}

void Bending::add_accelerations(const Float4Array& positions, ParallelKernels& kernels, Float4Array& accelerations) {
  const Float4* finer = positions.data();
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    BendingLevel& level = levels_[l];
    std::fill(level.positions.begin(), level.positions.end(), Float4{});
    std::fill(level.accelerations.begin(), level.accelerations.end(), Float4{});
    for (std::size_t row = 0; row < level.cluster_indices.size(); ++row) {
      add_scaled(level.positions[level.cluster_indices[row]], finer[row], level.mass_fraction[row]);
    }
    kernels.add_product(level.matrix, level.positions.data(), level.accelerations.data());
    finer = level.positions.data();
  }
  for (std::size_t l = levels_.size(); l-- > 1;) {
    const BendingLevel& level = levels_[l];
    Float4Array& onto = l == 1 ? accelerations : levels_[l - 1].accelerations;
    for (std::size_t row = l == 1 ? first_free_row_ : 0; row < level.cluster_indices.size(); ++row) {
      add_scaled(onto[row], level.accelerations[level.cluster_indices[row]], 1.0F);
    }
  }
  kernels.add_product(levels_[0].matrix, positions.data(), accelerations.data());
}

}  // namespace taut::sim::bounded
