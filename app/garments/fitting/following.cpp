#include "app/garments/fitting/following.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/garments/fitting/sheets.hpp"
#include "app/garments/fitting/tuning.hpp"
#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {

using namespace fitting;

namespace {

constexpr sim::Index leaf_size = 4;
constexpr double infinite = std::numeric_limits<double>::infinity();

using sim::Index;
using sim::Vec3;

/// Returns the weights of the corners at the point of the triangle that is nearest to p.
std::array<double, 3> nearest_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const Vec3 normal = glm::cross(ab, ac);
  const double squared = glm::dot(normal, normal);
  if (squared > 0.0) {
    const double v = glm::dot(glm::cross(p - a, ac), normal) / squared;
    const double w = glm::dot(glm::cross(ab, p - a), normal) / squared;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) return {1.0 - v - w, v, w};
  }
  const double s = share_along(p, a, b), t = share_along(p, b, c), u = share_along(p, c, a);
  const std::array<std::array<double, 3>, 3> edges = {{{1.0 - s, s, 0.0}, {0.0, 1.0 - t, t}, {u, 0.0, 1.0 - u}}};
  const auto distance = [&](const std::array<double, 3>& at) {
    return glm::length(at[0] * a + at[1] * b + at[2] * c - p);
  };
  return *std::ranges::min_element(edges, [&](const auto& x, const auto& y) { return distance(x) < distance(y); });
}

Vec3 nearest_of_triangle(const Vec3& p, const std::array<Vec3, 3>& c) {
  const auto [u, v, w] = nearest_weights(p, c[0], c[1], c[2]);
  return u * c[0] + v * c[1] + w * c[2];
}

double square_distance(const sim::Vec3& p, const sim::Extent& box) {
  const sim::Vec3 way = glm::max(glm::max(box.lower - p, p - box.upper), sim::Vec3(0.0));
  return glm::dot(way, way);
}

/// Returns the distance at which the ray enters the box; infinite if it does not between these two distances.
double entry(const sim::Vec3& from, const sim::Vec3& inverse, double begin, double end, const sim::Extent& box) {
  for (int axis = 0; axis < 3; ++axis) {
    double near = (box.lower[axis] - from[axis]) * inverse[axis];
    double far = (box.upper[axis] - from[axis]) * inverse[axis];
    if (near > far) std::swap(near, far);
    begin = near > begin ? near : begin;  // `near` is not a number, and no limit, for a ray within a side
    end = far < end ? far : end;
  }
  return begin <= end ? begin : infinite;
}

/// Returns the distance along the ray (Moeller and Trumbore 1997); infinite beside the triangle.
double hit(const sim::Vec3& from, const sim::Vec3& direction, const std::array<sim::Vec3, 3>& c) {
  const sim::Vec3 e1 = c[1] - c[0], e2 = c[2] - c[0], p = glm::cross(direction, e2);
  const double determinant = glm::dot(e1, p);
  if (determinant == 0.0) return infinite;
  const sim::Vec3 s = from - c[0], q = glm::cross(s, e1);
  const double u = glm::dot(s, p) / determinant, v = glm::dot(direction, q) / determinant;
  return u < 0.0 || v < 0.0 || u + v > 1.0 ? infinite : glm::dot(e2, q) / determinant;
}

/// Returns the nearest triangle that faces along the normal; any triangle for a normal of 0.
std::optional<TreeSurfacePoint> find_nearest(const SurfaceTree& tree, const sim::Mesh& mesh, const Vec3& point,
                                             const Vec3& normal, double reach_m) {
  return tree.find_nearest(point, reach_m, [&](const TreeSurfacePoint& found) {
    return glm::dot(sim::doubled_area_vector(mesh.positions, mesh.triangles[found.triangle]), normal) >= 0.0;
  });
}

/// A vertex of the model and the point that it is bound to. Nearer ones are bound first.
struct Candidate {
  double distance_m;
  Index vertex;
  TreeSurfacePoint closest_point;
  bool operator>(const Candidate& other) const {
    return std::pair(distance_m, vertex) > std::pair(other.distance_m, other.vertex);
  }
};

/// Binds the vertices of a model one after the other along its edges, starting where the nearest surface is certain.
class Binder {
 public:
  Binder(const sim::Mesh& model, std::span<const std::uint8_t> is_wall, const sim::Mesh& mesh)
      : model_(model),
        mesh_(mesh),
        tree_(mesh.positions, mesh.triangles),
        of_model_(sim::make_adjacency(model)),
        triangles_at_(sim::at_vertices(mesh.positions.size(), mesh.triangles)),
        normals_(vertex_normals(model.positions, select_triangles(model, is_wall).triangles)),
        facing_(model.positions.size()),
        found_(model.positions.size()),
        edge_m_(mean_edge_m(mesh)) {}

  std::vector<TreeSurfacePoint> all() {
    // Parts of the wall come before other parts. Each begins at its most certain vertex.
    for (const bool is_carried : {false, true}) {
      for (const Candidate& seed : seeds(is_carried)) {
        if (!found_[seed.vertex]) spread(seed);
      }
    }
    std::vector<TreeSurfacePoint> points;
    for (Index v = 0; v < found_.size(); ++v) {
      points.push_back(found_[v] ? *found_[v] : *find_nearest(tree_, mesh_, model_.positions[v], Vec3(0.0), infinite));
    }
    return points;
  }

 private:
  const TreeSurfacePoint& nearest_facing(Index v) {
    throw_if_interrupted();
    if (!facing_[v]) {
      const Vec3& place_m = model_.positions[v];
      const TreeSurfacePoint any = *find_nearest(tree_, mesh_, place_m, Vec3(0.0), infinite);
      const Vec3 way = sim::doubled_area_vector(mesh_.positions, mesh_.triangles[any.triangle]);
      facing_[v] = glm::dot(way, normals_[v]) >= 0.0
                       ? any
                       : find_nearest(tree_, mesh_, place_m, normals_[v], any.distance_m + edge_m_).value_or(any);
    }
    return *facing_[v];
  }

  /// Returns the vertices of the wall, or all others. Vertices that are furthest from layers facing the other way come
  /// first.
  std::vector<Candidate> seeds(bool is_carried) {
    std::vector<Candidate> seeds;
    for (Index v = 0; v < found_.size(); ++v) {
      if (found_[v] || (normals_[v] == Vec3(0.0)) != is_carried) continue;
      const TreeSurfacePoint& own = nearest_facing(v);
      const auto other =
          is_carried ? std::nullopt : find_nearest(tree_, mesh_, model_.positions[v], -normals_[v], 4.0 * edge_m_);
      const double clear_m = other ? other->distance_m : 4.0 * edge_m_;
      seeds.push_back({own.distance_m - clear_m, v, own});
    }
    std::ranges::sort(seeds, [](const Candidate& a, const Candidate& b) { return b > a; });
    return seeds;
  }

  void spread(const Candidate& seed) {
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue;
    queue.push(seed);
    while (!queue.empty()) {
      throw_if_interrupted();
      const Candidate next = queue.top();
      queue.pop();
      if (found_[next.vertex]) continue;
      found_[next.vertex] = next.closest_point;
      for (const Index e : of_model_.vertex_edges[next.vertex]) {
        const Index other = sim::other_end(of_model_.edges[e], next.vertex);
        if (!found_[other]) {
          const TreeSurfacePoint found = near_to(next.closest_point.triangle, other);
          queue.push({found.distance_m, other, found});
        }
      }
    }
  }

  /// Returns the point that is reached from a triangle by steps that come nearer to the vertex. Returns the nearest
  /// point anywhere if that is much nearer, as where the mesh ends.
  TreeSurfacePoint near_to(Index triangle, Index vertex) {
    TreeSurfacePoint best{infinite, triangle, Vec3(0.0)};
    for (bool is_nearer = true; is_nearer;) {
      is_nearer = false;
      const sim::Triangle from = mesh_.triangles[best.triangle];
      for (const Index corner : from) {
        for (const Index t : triangles_at_[corner]) {
          is_nearer = try_nearer(t, vertex, best) || is_nearer;
        }
      }
    }
    const TreeSurfacePoint& anywhere = nearest_facing(vertex);
    return best.distance_m > 2.0 * anywhere.distance_m + 3.0 * edge_m_ ? anywhere : best;
  }

  bool try_nearer(Index t, Index vertex, TreeSurfacePoint& best) const {
    const Vec3 place_m =
        nearest_of_triangle(model_.positions[vertex], sim::corner_positions(mesh_.triangles[t], mesh_.positions));
    const double distance_m = glm::distance(place_m, model_.positions[vertex]);
    if (distance_m < best.distance_m) {
      best = {distance_m, t, place_m};
      return true;
    }
    return false;
  }

  const sim::Mesh& model_;
  const sim::Mesh& mesh_;
  SurfaceTree tree_;
  sim::Adjacency of_model_;
  sim::CompressedRows triangles_at_;                     ///< triangles of the mesh, by vertex
  std::vector<Vec3> normals_;                            ///< normals of the wall's vertices; 0 at other vertices
  std::vector<std::optional<TreeSurfacePoint>> facing_;  ///< cache of nearest_facing()
  std::vector<std::optional<TreeSurfacePoint>> found_;
  double edge_m_;
};

/// Position of a bond, and axes that turn with the triangle: along its first edge, across it, along the normal.
struct BondFrame {
  Vec3 place_m, along, across, normal;
};

Vec3 find_foot(const Bond& bond, std::span<const Vec3> positions_m, std::span<const sim::Triangle> triangles) {
  const auto& [a, b, c] = triangles[bond.triangle];
  const auto& [u, v, w] = bond.weights;
  return u * positions_m[a] + v * positions_m[b] + w * positions_m[c];
}

BondFrame make_bond_frame(const Bond& bond, std::span<const Vec3> positions_m, std::span<const Vec3> normals,
                          std::span<const sim::Triangle> triangles) {
  const auto& [a, b, c] = triangles[bond.triangle];
  const auto& [u, v, w] = bond.weights;
  BondFrame frame;
  frame.place_m = find_foot(bond, positions_m, triangles);
  const Vec3 edge = positions_m[b] - positions_m[a];
  // Vertex normals may cancel out where the cloth is folded over. Triangle normals differ between neighbours.
  const Vec3 face_normal = sim::unit_or_zero(glm::cross(edge, positions_m[c] - positions_m[a]));
  frame.normal = sim::unit_or_zero(face_normal_weight * face_normal + u * normals[a] + v * normals[b] + w * normals[c]);
  frame.along = sim::unit_or_zero(edge - glm::dot(edge, frame.normal) * frame.normal);
  frame.across = glm::cross(frame.normal, frame.along);
  return frame;
}

std::vector<Bond> bonds_at(std::span<const Vec3> points_m, std::span<const TreeSurfacePoint> found,
                           const sim::Mesh& mesh, int smoothing_rounds = 0) {
  const std::vector<Vec3> normals = vertex_normals(mesh.positions, mesh.triangles, smoothing_rounds);
  std::vector<Bond> bonds;
  bonds.reserve(points_m.size());
  for (std::size_t k = 0; k < points_m.size(); ++k) {
    const auto& [a, b, c] = mesh.triangles[found[k].triangle];
    Bond bond{found[k].triangle,
              nearest_weights(found[k].place_m, mesh.positions[a], mesh.positions[b], mesh.positions[c])};
    const BondFrame frame = make_bond_frame(bond, mesh.positions, normals, mesh.triangles);
    const Vec3 offset_m = points_m[k] - frame.place_m;
    bond.offset_m = {glm::dot(offset_m, frame.along), glm::dot(offset_m, frame.across),
                     glm::dot(offset_m, frame.normal)};
    bonds.push_back(bond);
  }
  return bonds;
}

}  // namespace

double share_along(const sim::Vec3& point, const sim::Vec3& a, const sim::Vec3& b) {
  const double squared = glm::dot(b - a, b - a);
  return squared > 0.0 ? std::clamp(glm::dot(point - a, b - a) / squared, 0.0, 1.0) : 0.0;
}

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
  const int axis = sim::long_axis(middles);
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

template <class DistanceTo, class Look>
void SurfaceTree::search(const DistanceTo& distance_to, const double& reach, const Look& look) const {
  std::array<sim::Index, 64> stack{};
  std::size_t waiting = nodes_.empty() ? 0 : 1;
  while (waiting > 0) {
    const sim::Index at = stack[--waiting];
    const SurfaceTreeNode& node = nodes_[at];
    if (distance_to(node.extent) > reach) continue;
    if (node.second != 0) {
      const bool first_is_nearer = distance_to(nodes_[at + 1].extent) <= distance_to(nodes_[node.second].extent);
      stack[waiting++] = first_is_nearer ? node.second : at + 1;
      stack[waiting++] = first_is_nearer ? at + 1 : node.second;
      continue;
    }
    for (sim::Index i = node.begin; i < node.end; ++i) look(order_[i]);
  }
}

std::optional<TreeSurfacePoint> SurfaceTree::find_nearest(const sim::Vec3& from_m, double reach_m,
                                                          const AcceptPoint& accept, std::size_t* looks) const {
  std::optional<TreeSurfacePoint> best;
  double best_square = reach_m * reach_m;
  const auto distance_to = [&](const sim::Extent& box) { return square_distance(from_m, box); };
  search(distance_to, best_square, [&](sim::Index t) {
    if (looks != nullptr) ++*looks;
    const sim::Vec3 place = nearest_of_triangle(from_m, corners_[t]);
    const double square = glm::dot(place - from_m, place - from_m);
    const TreeSurfacePoint found{std::sqrt(square), t, place};
    const bool is_nearer = square < best_square || (best && square == best_square && t < best->triangle);
    if (is_nearer && accept(found)) {
      best = found;
      best_square = square;
    }
  });
  return best;
}

std::optional<TreeSurfacePoint> SurfaceTree::first_hit(const sim::Vec3& from_m, const sim::Vec3& direction,
                                                       double begin_m, double end_m, const AcceptPoint& accept) const {
  std::optional<TreeSurfacePoint> best;
  const sim::Vec3 inverse = 1.0 / direction;
  const auto distance_to = [&](const sim::Extent& box) { return entry(from_m, inverse, begin_m, end_m, box); };
  search(distance_to, end_m, [&](sim::Index t) {
    const double distance = hit(from_m, direction, corners_[t]);
    const TreeSurfacePoint found{distance, t, from_m + distance * direction};
    const bool is_nearer = distance < end_m || (best && distance == end_m && t < best->triangle);
    if (distance >= begin_m && is_nearer && accept(found)) {
      best = found;
      end_m = distance;
    }
  });
  return best;
}

double mean_edge_m(const sim::Mesh& mesh) {
  const std::vector<sim::Edge> edges = sim::make_adjacency(mesh).edges;
  double sum_m = 0.0;
  for (const auto& [a, b] : edges) sum_m += glm::distance(mesh.positions[a], mesh.positions[b]);
  return sum_m / static_cast<double>(edges.size());
}

std::vector<Vec3> vertex_normals(std::span<const Vec3> positions_m, std::span<const sim::Triangle> triangles,
                                 int smoothing_rounds) {
  std::vector<Vec3> normals(positions_m.size(), Vec3(0.0));
  for (const sim::Triangle& t : triangles) {
    const Vec3 area = sim::doubled_area_vector(positions_m, t);
    for (const Index v : t) normals[v] += area;
  }
  std::ranges::transform(normals, normals.begin(), sim::unit_or_zero);
  for (int round = 0; round < smoothing_rounds; ++round) {
    std::vector<Vec3> sums = normals;
    for (const sim::Triangle& t : triangles) {
      for (const Index v : t) sums[v] += normals[t[0]] + normals[t[1]] + normals[t[2]];
    }
    std::ranges::transform(sums, normals.begin(), sim::unit_or_zero);
  }
  return normals;
}

std::vector<Bond> bonds_to(std::span<const Vec3> points_m, const sim::Mesh& mesh, std::span<const Vec3> normals) {
  const SurfaceTree tree(mesh.positions, mesh.triangles);
  std::vector<TreeSurfacePoint> closest_points;
  closest_points.reserve(points_m.size());
  for (std::size_t k = 0; k < points_m.size(); ++k) {
    throw_if_interrupted();
    closest_points.push_back(find_nearest(tree, mesh, points_m[k], Vec3(0.0), infinite).value());
    if (!normals.empty()) {
      closest_points[k] =
          find_nearest(tree, mesh, points_m[k], normals[k], max_facing_distance_ratio * closest_points[k].distance_m)
              .value_or(closest_points[k]);
    }
  }
  return bonds_at(points_m, closest_points, mesh);
}

std::vector<Index> find_rigid_parts(const sim::Mesh& model, std::span<const std::uint8_t> is_wall) {
  sim::Groups groups = sim::connect_vertices(model.positions.size(), model.triangles);
  std::map<Index, sim::Extent> extents;
  for (Index v = 0; v < model.positions.size(); ++v) extents[groups.find(v)].add(model.positions[v]);
  for (const sim::Triangle& t : select_triangles(model, is_wall).triangles) extents.erase(groups.find(t[0]));
  std::erase_if(extents, [](const auto& part) { return glm::length(part.second.size()) > max_rigid_size_m; });
  std::vector<Index> parts;
  for (Index v = 0; v < model.positions.size(); ++v) {
    const Index part = groups.find(v);
    parts.push_back(extents.contains(part) ? part : sim::no_vertex);
  }
  return parts;
}

std::vector<Bond> bonds_of_model(const sim::Mesh& model, std::span<const std::uint8_t> is_wall, const sim::Mesh& mesh) {
  std::vector<TreeSurfacePoint> points = Binder(model, is_wall, mesh).all();
  const std::vector<Index> parts = find_rigid_parts(model, is_wall);
  for (Index v = 0; v < points.size(); ++v) {
    if (parts[v] != sim::no_vertex) points[v] = points[parts[v]];
  }
  return bonds_at(model.positions, points, mesh, normal_smoothing_rounds);
}

std::vector<Vec3> follow(std::span<const Bond> bonds, std::span<const Vec3> positions_m,
                         std::span<const sim::Triangle> triangles, int smoothing_rounds) {
  const std::vector<Vec3> normals = vertex_normals(positions_m, triangles, smoothing_rounds);
  std::vector<Vec3> points_m;
  points_m.reserve(bonds.size());
  for (const Bond& bond : bonds) {
    const BondFrame frame = make_bond_frame(bond, positions_m, normals, triangles);
    points_m.push_back(frame.place_m + bond.offset_m.x * frame.along + bond.offset_m.y * frame.across +
                       bond.offset_m.z * frame.normal);
  }
  return points_m;
}

std::vector<Vec3> find_feet(std::span<const Bond> bonds, std::span<const Vec3> positions_m,
                            std::span<const sim::Triangle> triangles) {
  return collect<Vec3>(bonds, [&](const Bond& bond) { return find_foot(bond, positions_m, triangles); });
}

Index find_nearest_corner(const Bond& bond, std::span<const sim::Triangle> triangles) {
  const auto largest = std::ranges::max_element(bond.weights);
  return triangles[bond.triangle][static_cast<std::size_t>(largest - bond.weights.begin())];
}

}  // namespace taut::app
