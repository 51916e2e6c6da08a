#include "sim/mesh/geodesics.hpp"

namespace taut::sim {
namespace {

/// Returns the distance of corner c of a triangle from a source, along a straight line in the unfolded triangle.
/// `from_a` and `from_b` are the source's distances from the other corners. Returns nothing if the line does not cross
/// the edge a-b.
std::optional<double> unfolded_distance(const Vec3& a, const Vec3& b, const Vec3& c, double from_a, double from_b) {
  const double base = glm::length(b - a);
  if (!(base > 0.0)) return std::nullopt;
  // Coordinates in the plane of the triangle: a at the origin, b on the x axis, c above it and the source below.
  const double source_x = (from_a * from_a - from_b * from_b + base * base) / (2.0 * base);
  const double source_depth2 = from_a * from_a - source_x * source_x;
  const double c_x = glm::dot(c - a, b - a) / base;
  const double c_height = glm::length(glm::cross(b - a, c - a)) / base;
  if (!(source_depth2 > 0.0) || !(c_height > 0.0)) return std::nullopt;
  const double source_depth = std::sqrt(source_depth2);
  const double crossing_x = source_x + (c_x - source_x) * source_depth / (source_depth + c_height);
  if (crossing_x < 0.0 || crossing_x > base) return std::nullopt;
  // Not std::hypot: its last bits depend on the C library and the processor.
  const double along = c_x - source_x;
  const double across = source_depth + c_height;
  return std::sqrt(along * along + across * across);
}

/// Front that spreads from the sources, nearest vertex first (Dijkstra 1959).
class GeodesicFront {
 public:
  GeodesicFront(const Mesh& mesh, const Adjacency& adjacency) : mesh_(mesh), adjacency_(adjacency) {
    const std::size_t count = mesh.positions.size();
    reached_.distances_m.assign(count, std::numeric_limits<double>::infinity());
    reached_.nearest_sources.assign(count, GeodesicDistances::no_source);
    is_passed_.assign(count, false);
  }

  void reach(Index v, double distance_m, Index source) {
    if (!is_passed_[v] && distance_m < reached_.distances_m[v]) {
      reached_.distances_m[v] = distance_m;
      reached_.nearest_sources[v] = source;
      waiting_.emplace(distance_m, v);
    }
  }

  GeodesicDistances spread() {
    while (!waiting_.empty()) {
      const Index v = waiting_.top().second;
      waiting_.pop();
      if (!is_passed_[v]) {
        is_passed_[v] = true;
        for (const Index e : adjacency_.vertex_edges[v]) pass_on(v, e);
      }
    }
    return std::move(reached_);
  }

 private:
  void pass_on(Index v, Index edge) {
    const Index other = other_end(adjacency_.edges[edge], v);
    const std::vector<Vec3>& x = mesh_.positions;
    const double from_v_m = reached_.distances_m[v];
    reach(other, from_v_m + glm::length(x[other] - x[v]), reached_.nearest_sources[v]);
    if (!is_passed_[other]) return;
    for (const Index t : adjacency_.edge_triangles[edge]) {
      const Triangle& triangle = mesh_.triangles[t];
      for (const Index c : triangle) {
        if (c != v && c != other) {
          const double from_other_m = reached_.distances_m[other];
          const bool is_v_nearer = from_v_m < from_other_m;
          if (const auto d = unfolded_distance(x[v], x[other], x[c], from_v_m, from_other_m)) {
            reach(c, *d, reached_.nearest_sources[is_v_nearer ? v : other]);
          }
        }
      }
    }
  }

  const Mesh& mesh_;
  const Adjacency& adjacency_;
  GeodesicDistances reached_;
  std::vector<bool> is_passed_;
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>, std::greater<>> waiting_;
};

}  // namespace

GeodesicDistances geodesic_distances(const Mesh& mesh, const Adjacency& adjacency, std::span<const Index> sources) {
  GeodesicFront front(mesh, adjacency);
  for (const Index source : sources) {
    assert(source < mesh.positions.size());
    front.reach(source, 0.0, source);
  }
  return front.spread();
}

}  // namespace taut::sim
