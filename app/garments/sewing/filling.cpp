#include "app/garments/sewing/filling.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/garments/fitting/triangle_net.hpp"
#include "app/garments/sewing/tuning.hpp"
#include "app/verify/orientation.hpp"
#include "sim/mesh/polygons.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec2;
using sim::Vec3;
using namespace sewing;

bool is_inside(const std::vector<Vec2>& outline, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Vec2 &a = outline[i], &b = outline[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) inside = !inside;
  }
  return inside;
}

double distance_to(const std::vector<Vec2>& outline, const Vec2& p) {
  double min_distance = glm::distance(outline[0], p);
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Vec2 way = outline[i] - outline[j];
    const double share = std::clamp(glm::dot(p - outline[j], way) / glm::dot(way, way), 0.0, 1.0);
    min_distance = std::min(min_distance, glm::distance(p, outline[j] + share * way));
  }
  return min_distance;
}

/// Returns points of a triangular grid within the outline, each moved a little by multiples of the inverse plastic
/// number, which are spread evenly.
std::vector<Vec2> points_within(const std::vector<Vec2>& outline, double edge, double jitter) {
  constexpr double first_step = 0.7548776662466927, second_step = 0.5698402909980532;
  Vec2 low = outline[0], high = outline[0];
  for (const Vec2& p : outline) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  std::vector<Vec2> points;
  double number = 0.0;
  const double row_height = edge * std::sqrt(0.75);
  const auto rows = static_cast<int>((high.y - low.y) / row_height),
             columns = static_cast<int>((high.x - low.x) / edge);
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      number += 1.0;
      const Vec2 moved = {number * first_step - std::floor(number * first_step) - 0.5,
                          number * second_step - std::floor(number * second_step) - 0.5};
      const Vec2 p =
          low + Vec2((column + (row % 2 == 0 ? 0.25 : 0.75)) * edge, (row + 0.5) * row_height) + jitter * edge * moved;
      if (is_inside(outline, p) && distance_to(outline, p) > clearance_fraction * edge) points.push_back(p);
    }
  }
  return points;
}

/// A Delaunay triangulation that keeps the edges of the outline (Lawson 1977).
class Triangulation {
 public:
  explicit Triangulation(const std::vector<Vec2>& outline) : outline_(outline.size()) {
    const auto corners_m = collect<Vec3>(outline, [](const Vec2& p) { return Vec3(p, 0.0); });
    std::vector<Index> corners(outline_);
    std::iota(corners.begin(), corners.end(), Index{0});
    const std::uint32_t count = static_cast<std::uint32_t>(corners.size());
    for (const Vec2& p : outline) add(p);
    const std::vector<sim::Triangle> triangles = sim::cut_into_triangles({corners_m, std::span(&count, 1), corners});
    add_triangles(triangles, net_);
    require_simple(triangles.size());
    flip_all();
  }

  void insert(const Vec2& p) {
    throw_if_interrupted();
    for (const Face f : net_.faces()) {
      if (!is_around(f, p)) continue;
      net_.split(f, add(p));
      std::vector<Edge> opposite;
      for (const Halfedge h : net_.voh_range(Vertex(static_cast<int>(points_.size() - 1)))) {
        opposite.push_back(net_.edge_handle(net_.next_halfedge_handle(h)));
      }
      return flip(std::move(opposite));
    }
  }

  /// Adds a point in the middle of the largest triangle.
  void insert() {
    const std::vector<sim::Triangle> triangles = to_triangles(net_);
    const auto [a, b, c] = *std::ranges::max_element(
        triangles, {}, [&](const auto& t) { return sim::doubled_area(points_[t[0]], points_[t[1]], points_[t[2]]); });
    insert((points_[a] + points_[b] + points_[c]) / 3.0);
  }

  /// Moves inner points to the means of their neighbours unless a triangle turns over. Points that moved count only in
  /// the next round: triangles would become so even that rows fold along themselves.
  void smooth() {
    std::vector<Vec2> means = points_;
    for (std::size_t n = outline_; n < points_.size(); ++n) {
      const Vertex v(static_cast<int>(n));
      means[n] = Vec2(0.0);
      for (const Vertex other : net_.vv_range(v)) means[n] += at(other) / static_cast<double>(net_.valence(v));
    }
    for (std::size_t n = outline_; n < points_.size(); ++n) {
      const Vertex v(static_cast<int>(n));
      const std::vector<double> areas_before = areas_around(v);
      const Vec2 before = std::exchange(points_[n], means[n]);
      const auto is_kept = [](double now, double then) { return now > 0.1 * then; };
      if (!std::ranges::equal(areas_around(v), areas_before, is_kept)) points_[n] = before;
    }
    flip_all();
  }

  /// Halves inner edges with both ends on the outline. They could meet others where the outline is sewn.
  void halve_across() {
    for (const Edge e : all_edges()) {
      const Diamond d = diamond(net_, e);
      if (!net_.is_boundary(e) && std::max(number(d.a), number(d.b)) < outline_) {
        net_.split(e, add(0.5 * (at(d.a) + at(d.b))));
      }
    }
  }

  void require_areas() const {
    for (const Face f : net_.faces()) {
      if (!(area(f) > 0.0)) throw std::invalid_argument("it is too narrow to be filled with triangles");
    }
  }

  FilledOutline take() { return {std::move(points_), to_triangles(net_)}; }

 private:
  const Vec2& at(Vertex v) const { return points_[number(v)]; }
  double area(Face f) const {
    const auto [a, b, c] = to_triangle(net_, f);
    return sim::doubled_area(points_[a], points_[b], points_[c]);
  }
  std::vector<double> areas_around(Vertex v) const {
    std::vector<double> areas;
    for (const Face f : net_.vf_range(v)) areas.push_back(area(f));
    return areas;
  }

  void require_simple(std::size_t triangles) const {
    double sum = 0.0, least = 0.0;
    for (const Face f : net_.faces()) {
      sum += std::abs(area(f));
      least = std::min(least, area(f));
    }
    // Triangles along straight borders have no area until they are flipped.
    const bool is_whole = triangles + 2 == outline_ && net_.n_faces() == triangles;
    if (!is_whole || least < -1e-9 * sum || std::abs(sum - 2.0 * polygon_area(points_)) > 1e-6 * sum) {
      throw std::invalid_argument("its outline crosses or touches itself");
    }
  }

  Vertex add(const Vec2& p) {
    points_.push_back(p);
    return net_.new_vertex();
  }

  std::vector<Edge> all_edges() const {
    std::vector<Edge> edges;
    for (const Edge e : net_.edges()) edges.push_back(e);
    return edges;
  }
  void flip_all() { flip(all_edges()); }

  /// Flips edges until all are Delaunay. `waiting` are those that may not be.
  void flip(std::vector<Edge> waiting) {
    while (!waiting.empty()) {
      const Edge e = waiting.back();
      waiting.pop_back();
      if (net_.is_boundary(e) || !may_flip(diamond(net_, e))) continue;
      net_.flip(e);
      for (const unsigned side : {0U, 1U}) {
        const Halfedge h = net_.halfedge_handle(e, side);
        waiting.push_back(net_.edge_handle(net_.next_halfedge_handle(h)));
        waiting.push_back(net_.edge_handle(net_.prev_halfedge_handle(h)));
      }
    }
  }

  /// Returns whether the other diagonal is inside the diamond and makes its angles wider, by more than rounding.
  bool may_flip(const Diamond& d) const {
    const Vec2 &a = at(d.a), &b = at(d.b), &c = at(d.left), &e = at(d.right);
    if (orientation(a, e, c) <= 0 || orientation(e, b, c) <= 0) return false;
    // The angles at c and e over the edge from a to b then add up to more than half a turn.
    const double at_c = glm::dot(a - c, b - c), at_e = glm::dot(a - e, b - e);
    const double sine_c = sim::doubled_area(c, a, b), sine_e = sim::doubled_area(e, b, a);
    const double size = (std::abs(at_c) + sine_c) * (std::abs(at_e) + std::abs(sine_e));
    return at_c * sine_e + at_e * sine_c < -1e-10 * size;
  }

  bool is_around(Face f, const Vec2& p) const {
    const auto [a, b, c] = to_triangle(net_, f);
    const auto is_left_of = [&](Index i, Index k) { return orientation(points_[i], points_[k], p) > 0; };
    return is_left_of(a, b) && is_left_of(b, c) && is_left_of(c, a);
  }

  std::vector<Vec2> points_;
  std::size_t outline_;  ///< count of points of the outline, which come first
  OpenMesh::TriConnectivity net_;
};

}  // namespace

double polygon_area(const std::vector<Vec2>& outline) {
  double area = 0.0;
  for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
    area += 0.5 * sim::doubled_area(outline[0], outline[k], outline[k + 1]);
  }
  return area;
}

FilledOutline fill_outline(std::vector<Vec2> outline_m, double edge_m, const Filling& filling) {
  const double area_m2 = polygon_area(outline_m);
  if (!(std::abs(area_m2) > 0.0)) throw std::invalid_argument("its outline has no area");
  if (area_m2 < 0.0) throw std::invalid_argument("its outline goes clockwise");
  Triangulation triangulation(outline_m);
  for (const Vec2& p : points_within(outline_m, edge_m, filling.jitter)) triangulation.insert(p);
  for (std::size_t k = 0; k < filling.more_points; ++k) triangulation.insert();
  for (int round = 0; round < smoothing_rounds; ++round) triangulation.smooth();
  triangulation.halve_across();
  triangulation.require_areas();
  return triangulation.take();
}

}  // namespace taut::app
