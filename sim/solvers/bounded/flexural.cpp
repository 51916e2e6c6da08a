#include "sim/solvers/bounded/flexural.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

namespace taut::sim::bounded {
namespace {

/// The mean over all directions of the fourth power of the cosine is 3/8: of the bending energy of a cylinder
/// springs in all directions see that part.
constexpr double cylinder_factor = 8.0 / 3.0;
/// Springs along the two directions of a grid: one of the two bends.
constexpr double grid_factor = 2.0;

/// Where two lines come closest: parameters along a-b and along v-c.
struct Crossing {
  double s;
  double t;
};

std::optional<Crossing> crossing_of(const Vec3& a, const Vec3& b, const Vec3& v, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 vc = c - v;
  const Vec3 va = a - v;
  const double ab2 = glm::dot(ab, ab);
  const double vc2 = glm::dot(vc, vc);
  const double mixed = glm::dot(ab, vc);
  const double determinant = ab2 * vc2 - mixed * mixed;
  if (!(determinant > 1e-3 * ab2 * vc2)) {
    return std::nullopt;
  }
  const double from_a = glm::dot(ab, va);
  const double from_v = glm::dot(vc, va);
  return Crossing{(mixed * from_v - vc2 * from_a) / determinant,
                  (ab2 * from_v - mixed * from_a) / determinant};
}

class Neighbours {
 public:
  explicit Neighbours(const Garment& garment)
      : edges_(garment.adjacency.edges), edges_at_(garment.adjacency.vertex_edges) {}

  std::vector<Index> of(Index v) const {
    std::vector<Index> neighbours;
    for (const Index e : edges_at_[v]) {
      neighbours.push_back(other_end(edges_[e], v));
    }
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

/// The crossing nearest to the middle of the spring, among the lines from the vertices both ends are joined
/// to. Lines are followed a little beyond v: at a border the spring can pass where there is no cloth.
std::optional<FlexuralElement> element_of(const Edge& spring, const std::vector<Vec3>& positions,
                                          const Neighbours& neighbours) {
  const auto [a, b] = spring;
  std::optional<FlexuralElement> best;
  double best_offset = 0.3;
  for (const Index v : neighbours.common(a, b)) {
    for (const Index c : neighbours.of(v)) {
      if (c == a || c == b) {
        continue;
      }
      const auto crossing = crossing_of(positions[a], positions[b], positions[v], positions[c]);
      if (!crossing || !(crossing->t >= -0.5 && crossing->t <= 1.0)) {
        continue;
      }
      const auto [s, t] = *crossing;
      const double offset = std::abs(s - 0.5) + 1e-3 * std::abs(t);
      if (offset < best_offset) {
        best_offset = offset;
        const double length_m = glm::length(positions[a] - positions[b]);
        const double deflection_per_curvature = s * (1.0 - s) * length_m * length_m / 2.0;
        best = {{a, b, v, c},
                {1.0 - s, s, t - 1.0, -t},
                1.0 / (deflection_per_curvature * deflection_per_curvature)};
      }
    }
  }
  return best;
}

/// Makes the stiffness of each element per area that of the area it stands for: the area about its vertex v,
/// divided among the elements there.
void scale_by_area(const Garment& garment, std::vector<FlexuralElement>& elements) {
  std::vector<double> count(garment.mesh.positions.size(), 0.0);
  for (const FlexuralElement& e : elements) {
    count[e.vertices[2]] += 1.0;
  }
  double covered_m2 = 0.0;
  double total_m2 = 0.0;
  for (std::size_t v = 0; v < count.size(); ++v) {
    const double area_m2 = garment.masses_kg[v] / garment.areal_density_kg_per_m2;
    total_m2 += area_m2;
    covered_m2 += count[v] > 0.0 ? area_m2 : 0.0;
  }
  const double factor = garment.mesh.quads.empty() ? cylinder_factor : grid_factor;
  for (FlexuralElement& e : elements) {
    const Index v = e.vertices[2];
    const double area_m2 = garment.masses_kg[v] / garment.areal_density_kg_per_m2;
    e.stiffness_per_rigidity *= factor * (total_m2 / covered_m2) * area_m2 / count[v];
  }
}

/// The square of the angular frequency of one element alone.
double squared_rate(const FlexuralElement& e, double stiffness, const Garment& garment) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    sum += garment.inverse_masses_per_kg[e.vertices[k]] * e.weights[k] * e.weights[k];
  }
  return stiffness * sum;
}

struct Entry {
  Index row;
  Index column;
  double value;
};

/// Sums entries of the same place; the result is in the order of rows, then columns.
std::vector<Entry> summed(std::vector<Entry> entries) {
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  });
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

std::vector<Entry> stiffness_entries(const Garment& garment, const Layout& layout, double rigidity_n_m,
                                     double stiffest_rate_per_s) {
  const double stiffest2 = stiffest_rate_per_s * stiffest_rate_per_s;
  std::vector<Entry> entries;
  for (const FlexuralElement& e : flexural_elements(garment)) {
    double k = rigidity_n_m * e.stiffness_per_rigidity;
    const double rate2 = squared_rate(e, k, garment);
    k *= rate2 > stiffest2 ? stiffest2 / rate2 : 1.0;
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = 0; q < 4; ++q) {
        const double value = k * e.weights[p] * e.weights[q];
        if (value != 0.0) {
          entries.push_back(
              {layout.row_of_vertex[e.vertices[p]], layout.row_of_vertex[e.vertices[q]], value});
        }
      }
    }
  }
  return summed(std::move(entries));
}

RowMatrix acceleration_matrix(const std::vector<Entry>& stiffness, const Layout& layout) {
  RowMatrix matrix;
  matrix.begin.push_back(0);
  auto e = stiffness.begin();
  for (Index row = 0; row < layout.vertex_count(); ++row) {
    const double w = layout.inverse_masses_per_kg[row];
    for (; e != stiffness.end() && e->row == row; ++e) {
      if (w > 0.0 && e->column != row) {
        matrix.column.push_back(e->column);
        matrix.value.push_back(static_cast<float>(-w * e->value));
      }
    }
    if (matrix.column.size() % 2 == 1) {
      matrix.column.push_back(row);
      matrix.value.push_back(0.0F);
    }
    matrix.begin.push_back(static_cast<std::uint32_t>(matrix.column.size()));
  }
  return matrix;
}

/// The square root of the largest eigenvalue of W K. The power method comes from below, and is close after a
/// few steps, as the highest modes are many and alike; the sum of a row's absolute values is never below.
double largest_rate(const std::vector<Entry>& stiffness, const Layout& layout) {
  constexpr int steps = 24;
  constexpr double margin = 1.15;
  std::vector<double> mode(layout.vertex_count());
  std::vector<double> image(layout.vertex_count());
  std::vector<double> row_sums(layout.vertex_count(), 0.0);
  for (std::size_t row = 0; row < mode.size(); ++row) {
    mode[row] = row % 2 == 0 ? 1.0 : -0.7;
  }
  double eigenvalue = 0.0;
  for (int step = 0; step < steps; ++step) {
    std::fill(image.begin(), image.end(), 0.0);
    for (const Entry& e : stiffness) {
      image[e.row] += layout.inverse_masses_per_kg[e.row] * e.value * mode[e.column];
    }
    const double largest = std::abs(*std::max_element(
        image.begin(), image.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
    if (!(largest > 0.0)) {
      break;
    }
    eigenvalue = largest;
    for (std::size_t row = 0; row < mode.size(); ++row) {
      mode[row] = image[row] / largest;
    }
  }
  for (const Entry& e : stiffness) {
    row_sums[e.row] += layout.inverse_masses_per_kg[e.row] * std::abs(e.value);
  }
  const double never_below = row_sums.empty() ? 0.0 : *std::max_element(row_sums.begin(), row_sums.end());
  return std::sqrt(std::min(never_below, margin * eigenvalue));
}

}  // namespace

std::vector<FlexuralElement> flexural_elements(const Garment& garment) {
  const Neighbours neighbours(garment);
  const Springs& springs = garment.springs;
  std::vector<FlexuralElement> elements;
  for (std::size_t s = springs.begin_of(SpringKind::flexural); s < springs.size(); ++s) {
    if (const auto element = element_of(springs.ends[s], garment.mesh.positions, neighbours)) {
      elements.push_back(*element);
    }
  }
  scale_by_area(garment, elements);
  return elements;
}

Bending make_bending(const Garment& garment, const Layout& layout, double rigidity_n_m,
                     double stiffest_rate_per_s) {
  if (!(rigidity_n_m > 0.0)) {
    return {};
  }
  const std::vector<Entry> stiffness = stiffness_entries(garment, layout, rigidity_n_m, stiffest_rate_per_s);
  return {acceleration_matrix(stiffness, layout), largest_rate(stiffness, layout)};
}

}  // namespace taut::sim::bounded
