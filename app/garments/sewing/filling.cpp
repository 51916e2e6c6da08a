#include "app/garments/sewing/filling.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/garments/sewing/tuning.hpp"
#include "app/verify/orientation.hpp"
#include "sim/mesh/polygons.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Triangle;
using sim::Vec2;
using sim::Vec3;
using namespace sewing;

constexpr Index none = static_cast<Index>(-1);

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
  explicit Triangulation(std::vector<Vec2> outline) : points_(std::move(outline)), outline_(points_.size()) {
    const auto corners_m = collect<Vec3>(points_, [](const Vec2& p) { return Vec3(p, 0.0); });
    std::vector<Index> corners(outline_);
    std::iota(corners.begin(), corners.end(), Index{0});
    const std::uint32_t count = static_cast<std::uint32_t>(corners.size());
    triangles_ = sim::cut_into_triangles({corners_m, std::span(&count, 1), corners});
    require_simple();
    for (Index t = 0; t < triangles_.size(); ++t) set(t, triangles_[t]);
    flip_all();
  }

  void insert(const Vec2& p) {
    throw_if_interrupted();
    const std::size_t t = triangle_around(p);
    if (t == triangles_.size()) return;
    const auto [a, b, c] = triangles_[t];
    const auto v = static_cast<Index>(points_.size());
    points_.push_back(p);
    set(static_cast<Index>(t), {a, b, v});
    add({b, c, v});
    add({c, a, v});
    flip_all();
  }

  /// Adds a point in the middle of the largest triangle.
  void insert() {
    const auto t = std::ranges::max_element(triangles_, {}, [&](const Triangle& triangle) { return area(triangle); });
    insert((points_[(*t)[0]] + points_[(*t)[1]] + points_[(*t)[2]]) / 3.0);
  }

  /// Moves inner points to the means of their neighbours unless a triangle turns over.
  void smooth() {
    std::vector<Vec2> sums(points_.size(), Vec2(0.0));
    std::vector<std::vector<Index>> around(points_.size());
    for (Index t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        sums[triangles_[t][k]] += points_[triangles_[t][(k + 1) % 3]];
        around[triangles_[t][k]].push_back(t);
      }
    }
    for (std::size_t v = outline_; v < points_.size(); ++v) {
      const auto areas = [&] { return collect<double>(around[v], [&](Index t) { return area(triangles_[t]); }); };
      const std::vector<double> areas_before = areas();
      const Vec2 before = std::exchange(points_[v], sums[v] / static_cast<double>(around[v].size()));
      const auto is_kept = [](double now, double then) { return now > 0.1 * then; };
      if (!std::ranges::equal(areas(), areas_before, is_kept)) points_[v] = before;
    }
    waiting_.resize(triangles_.size());
    std::iota(waiting_.begin(), waiting_.end(), Index{0});
    flip_all();
  }

  /// Halves inner edges with both ends on the outline. They could meet others where the outline is sewn.
  void halve_across() {
    for (Index t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (beyond(t, k) != none && triangles_[t][k] < outline_ && triangles_[t][(k + 1) % 3] < outline_) halve(t, k);
      }
    }
  }

  void require_areas() const {
    if (std::ranges::any_of(triangles_, [&](const Triangle& t) { return !(area(t) > 0.0); })) {
      throw std::invalid_argument("it is too narrow to be filled with triangles");
    }
  }

  FilledOutline take() { return {std::move(points_), std::move(triangles_)}; }

 private:
  double area(const Triangle& t) const { return sim::doubled_area(points_[t[0]], points_[t[1]], points_[t[2]]); }

  void require_simple() const {
    double sum = 0.0;
    for (const Triangle& t : triangles_) sum += std::abs(area(t));
    // Triangles along straight borders have no area until they are flipped.
    const bool is_turned = std::ranges::any_of(triangles_, [&](const Triangle& t) { return area(t) < -1e-9 * sum; });
    if (is_turned || triangles_.size() + 2 != outline_ || std::abs(sum - 2.0 * polygon_area(points_)) > 1e-6 * sum) {
      throw std::invalid_argument("its outline crosses or touches itself");
    }
  }

  /// Puts a triangle in this place, and lets its sides be flipped.
  void set(Index t, const Triangle& triangle) {
    triangles_[t] = triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle_along_[{triangle[k], triangle[(k + 1) % 3]}] = t;
    waiting_.push_back(t);
  }
  void add(const Triangle& triangle) {
    triangles_.emplace_back();
    set(static_cast<Index>(triangles_.size() - 1), triangle);
  }

  /// Returns the triangle beyond a side; none at the outline.
  Index beyond(Index t, std::size_t k) const {
    const auto found = triangle_along_.find({triangles_[t][(k + 1) % 3], triangles_[t][k]});
    return found == triangle_along_.end() ? none : found->second;
  }
  /// Returns the corner of the triangle that the edge from a to b does not have.
  Index corner_beside(Index t, Index a, Index b) const {
    return *std::ranges::find_if(triangles_[t], [&](Index v) { return v != a && v != b; });
  }
  void forget_edge(Index a, Index b) {
    triangle_along_.erase({a, b});
    triangle_along_.erase({b, a});
  }

  void flip_all() {
    for (std::size_t flips = 0; !waiting_.empty() && flips < max_flips * triangles_.size();) {
      const Index t = waiting_.back();
      waiting_.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        if (beyond(t, k) != none && flip(t, k)) {
          ++flips;
          break;
        }
      }
    }
    waiting_.clear();
  }

  /// Returns whether d is within the circle through the other three, by more than rounding.
  bool is_within_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) const {
    // The angles at c and d over the edge from a to b then add up to more than half a turn.
    const double at_c = glm::dot(a - c, b - c), at_d = glm::dot(a - d, b - d);
    const double sine_c = sim::doubled_area(c, a, b), sine_d = sim::doubled_area(d, b, a);
    const double size = (std::abs(at_c) + sine_c) * (std::abs(at_d) + std::abs(sine_d));
    return at_c * sine_d + at_d * sine_c < -1e-10 * size;
  }

  bool flip(Index t, std::size_t k) {
    const Index u = beyond(t, k);
    const Index a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
    const Index c = triangles_[t][(k + 2) % 3], d = corner_beside(u, a, b);
    const bool is_convex =
        orientation(points_[a], points_[d], points_[c]) > 0 && orientation(points_[d], points_[b], points_[c]) > 0;
    if (!is_convex || !is_within_circle(points_[a], points_[b], points_[c], points_[d])) return false;
    forget_edge(a, b);
    set(t, {a, d, c});
    set(u, {d, b, c});
    return true;
  }

  /// Returns the triangle around the point; the count of all if there is none.
  std::size_t triangle_around(const Vec2& p) const {
    const auto is_left_of = [&](Index a, Index b) { return orientation(points_[a], points_[b], p) > 0; };
    const auto is_around = [&](const Triangle& t) {
      return is_left_of(t[0], t[1]) && is_left_of(t[1], t[2]) && is_left_of(t[2], t[0]);
    };
    return static_cast<std::size_t>(std::ranges::find_if(triangles_, is_around) - triangles_.begin());
  }

  void halve(Index t, std::size_t k) {
    const Index u = beyond(t, k);
    const Index a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
    const Index c = triangles_[t][(k + 2) % 3], d = corner_beside(u, a, b);
    const auto v = static_cast<Index>(points_.size());
    points_.push_back(0.5 * (points_[a] + points_[b]));
    forget_edge(a, b);
    set(t, {a, v, c});
    add({v, b, c});
    set(u, {a, d, v});
    add({v, d, b});
  }

  std::vector<Vec2> points_;
  std::size_t outline_;
  std::vector<Triangle> triangles_;
  std::map<std::pair<Index, Index>, Index> triangle_along_;  ///< by the ends of its sides, counter-clockwise
  std::vector<Index> waiting_;                               ///< triangles whose sides may have to be flipped
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
