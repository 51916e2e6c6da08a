#include "sim/solvers/bounded/flexural.hpp"

namespace taut::sim::bounded {
namespace {

/// The factor for springs in all directions. They see only 3/8 of the bending energy of a cylinder: the mean
/// of the fourth power of the cosine over all directions.
constexpr double cylinder_factor = 8.0 / 3.0;
/// The factor for springs along the two directions of a grid. A cylinder bends only one of the two.
constexpr double grid_factor = 2.0;
/// Two lines cross if the squared sine of the angle between them is above this. A smaller value accepts lines
/// that are almost parallel, whose crossing is ill defined.
constexpr double least_squared_sine = 1e-3;
/// Of crossings equally far from the middle, this weight prefers the one nearer to v.
constexpr double distance_weight = 1e-3;

/// Where two lines are closest: the parameter s along a-b and t along v-c.
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
  if (!(determinant > least_squared_sine * ab2 * vc2)) return std::nullopt;
  const double from_a = glm::dot(ab, va);
  const double from_v = glm::dot(vc, va);
  return Crossing{(mixed * from_v - vc2 * from_a) / determinant, (ab2 * from_v - mixed * from_a) / determinant};
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

/// Returns the element whose crossing is nearest to the middle of the spring. It looks at the lines from each
/// vertex that is a neighbour of both ends. A line is extended beyond v because at a border the
/// spring can pass outside the cloth.
std::optional<FlexuralElement> element_of(const Edge& spring, const std::vector<Vec3>& positions,
                                          const Neighbours& neighbours) {
  const auto [a, b] = spring;
  std::optional<FlexuralElement> best;
  double best_offset = 0.5;  // within the spring
  for (const Index v : neighbours.common(a, b)) {
    for (const Index c : neighbours.of(v)) {
      if (c == a || c == b) continue;
      const auto crossing = crossing_of(positions[a], positions[b], positions[v], positions[c]);
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

/// Multiplies each element's stiffness by the area that it stands for: the area at its vertex v, divided
/// among the elements there.
void scale_by_area(const Garment& garment, std::vector<FlexuralElement>& elements) {
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
    if (!garment.others.empty()) {
      e.stiffness_per_rigidity *= own.bending_rigidity_n_m / garment.material.bending_rigidity_n_m;
    }
  }
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

}  // namespace taut::sim::bounded
