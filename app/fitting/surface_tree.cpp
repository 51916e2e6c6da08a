#include "app/fitting/surface_tree.hpp"

namespace taut::app {
namespace {

constexpr sim::Index leaf_size = 4;

double clamped_ratio(double part, double whole) { return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0; }

sim::Vec3 nearest_of_segment(const sim::Vec3& p, const sim::Vec3& a, const sim::Vec3& b) {
  return a + clamped_ratio(glm::dot(p - a, b - a), glm::dot(b - a, b - a)) * (b - a);
}

/// The foot in the plane where it is inside, else the nearest of the three sides'.
sim::Vec3 nearest_of_triangle(const sim::Vec3& p, const std::array<sim::Vec3, 3>& c) {
  const sim::Vec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
  const double square = glm::dot(normal, normal);
  bool is_inside = square > 0.0;
  for (int k = 0; k < 3 && is_inside; ++k) {
    is_inside = glm::dot(glm::cross(c[(k + 1) % 3] - c[k], p - c[k]), normal) >= 0.0;
  }
  if (is_inside) return p - glm::dot(p - c[0], normal) / square * normal;
  sim::Vec3 best(0.0);
  double best_square = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const sim::Vec3 q = nearest_of_segment(p, c[k], c[(k + 1) % 3]);
    const double found = glm::dot(q - p, q - p);
    if (found < best_square) {
      best = q;
      best_square = found;
    }
  }
  return best;
}

double square_distance(const sim::Vec3& p, const sim::Extent& box) {
  const sim::Vec3 way = glm::max(glm::max(box.lower - p, p - box.upper), sim::Vec3(0.0));
  return glm::dot(way, way);
}

/// Where the ray enters the box; infinite if it does not between these two distances.
double entry(const sim::Vec3& from, const sim::Vec3& inverse, double begin, double end, const sim::Extent& box) {
  for (int axis = 0; axis < 3; ++axis) {
    double near = (box.lower[axis] - from[axis]) * inverse[axis];
    double far = (box.upper[axis] - from[axis]) * inverse[axis];
    if (near > far) std::swap(near, far);
    begin = near > begin ? near : begin;  // not a number where the ray runs within a side: no limit
    end = far < end ? far : end;
  }
  return begin <= end ? begin : std::numeric_limits<double>::infinity();
}

/// The distance along the ray (Moeller and Trumbore 1997); infinite beside the triangle.
double hit(const sim::Vec3& from, const sim::Vec3& direction, const std::array<sim::Vec3, 3>& c) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const sim::Vec3 e1 = c[1] - c[0], e2 = c[2] - c[0], p = glm::cross(direction, e2);
  const double determinant = glm::dot(e1, p);
  if (determinant == 0.0) return none;
  const sim::Vec3 s = from - c[0], q = glm::cross(s, e1);
  const double u = glm::dot(s, p) / determinant, v = glm::dot(direction, q) / determinant;
  return u < 0.0 || v < 0.0 || u + v > 1.0 ? none : glm::dot(e2, q) / determinant;
}

}  // namespace

SurfaceTree::SurfaceTree(std::span<const sim::Vec3> positions_m, std::span<const sim::Triangle> triangles)
    : order_(triangles.size()) {
  std::vector<sim::Vec3> middles;
  for (const auto& [a, b, c] : triangles) {
    corners_.push_back({positions_m[a], positions_m[b], positions_m[c]});
    middles.push_back((positions_m[a] + positions_m[b] + positions_m[c]) / 3.0);
  }
  std::iota(order_.begin(), order_.end(), sim::Index{0});
  if (!order_.empty()) build(0, static_cast<sim::Index>(order_.size()), middles);
}

void SurfaceTree::build(sim::Index begin, sim::Index end, std::span<const sim::Vec3> middles_m) {
  const std::size_t at = nodes_.size();
  nodes_.push_back({{}, begin, end, 0});
  sim::Extent middles;
  for (sim::Index i = begin; i < end; ++i) {
    middles.add(middles_m[order_[i]]);
    for (const sim::Vec3& corner : corners_[order_[i]]) nodes_[at].extent.add(corner);
  }
  if (end - begin <= leaf_size) return;
  const int axis = sim::longest_axis(middles);
  const sim::Index half = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                   [&](sim::Index a, sim::Index b) {
                     const double x = middles_m[a][axis], y = middles_m[b][axis];
                     return x != y ? x < y : a < b;
                   });
  build(begin, half, middles_m);
  nodes_[at].second = static_cast<sim::Index>(nodes_.size());
  build(half, end, middles_m);
}

std::optional<SurfacePoint> SurfaceTree::nearest(const sim::Vec3& from_m, double reach_m,
                                                 const AcceptPoint& accept) const {
  std::optional<SurfacePoint> best;
  double best_square = reach_m * reach_m;
  std::array<sim::Index, 64> stack{};
  std::size_t waiting = nodes_.empty() ? 0 : 1;
  while (waiting > 0) {
    const sim::Index at = stack[--waiting];
    const Node& node = nodes_[at];
    if (square_distance(from_m, node.extent) > best_square) continue;
    if (node.second != 0) {
      const bool first_is_nearer =
          square_distance(from_m, nodes_[at + 1].extent) <= square_distance(from_m, nodes_[node.second].extent);
      stack[waiting++] = first_is_nearer ? node.second : at + 1;
      stack[waiting++] = first_is_nearer ? at + 1 : node.second;
      continue;
    }
    for (sim::Index i = node.begin; i < node.end; ++i) {
      const sim::Vec3 place = nearest_of_triangle(from_m, corners_[order_[i]]);
      const double square = glm::dot(place - from_m, place - from_m);
      const SurfacePoint found{std::sqrt(square), order_[i], place};
      const bool is_nearer = square < best_square || (best && square == best_square && order_[i] < best->triangle);
      if (is_nearer && accept(found)) {
        best = found;
        best_square = square;
      }
    }
  }
  return best;
}

std::optional<SurfacePoint> SurfaceTree::first_hit(const sim::Vec3& from_m, const sim::Vec3& direction, double begin_m,
                                                   double end_m, const AcceptPoint& accept) const {
  std::optional<SurfacePoint> best;
  const sim::Vec3 inverse = 1.0 / direction;
  std::array<sim::Index, 64> stack{};
  std::size_t waiting = nodes_.empty() ? 0 : 1;
  while (waiting > 0) {
    const sim::Index at = stack[--waiting];
    const Node& node = nodes_[at];
    if (!(entry(from_m, inverse, begin_m, end_m, node.extent) <= end_m)) continue;
    if (node.second != 0) {
      stack[waiting++] = node.second;
      stack[waiting++] = at + 1;
      continue;
    }
    for (sim::Index i = node.begin; i < node.end; ++i) {
      const double distance = hit(from_m, direction, corners_[order_[i]]);
      const SurfacePoint found{distance, order_[i], from_m + distance * direction};
      const bool is_nearer = distance < end_m || (best && distance == end_m && order_[i] < best->triangle);
      if (distance >= begin_m && is_nearer && accept(found)) {
        best = found;
        end_m = distance;
      }
    }
  }
  return best;
}

}  // namespace taut::app
