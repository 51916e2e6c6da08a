#include "sim/solvers/implicit/system.hpp"

#include "sim/mesh/elementary.hpp"

namespace taut::sim::implicit {
namespace {

/// Returns the warp direction in the plane of a triangle at rest, relative to its first side and the perpendicular on
/// its left.
Vec2 triangle_warp(const Garment& garment, std::size_t triangle) {
  const std::size_t quad = triangle / 2;
  if (quad >= garment.mesh.quads.size()) return {1.0, 0.0};
  const auto [a, b, c] = corner_positions(garment.mesh.triangles[triangle], garment.mesh.positions);
  const Quad& cell = garment.mesh.quads[quad];
  const Vec3 down = glm::normalize(garment.mesh.positions[cell[1]] - garment.mesh.positions[cell[0]]);
  const Vec3 side = glm::normalize(b - a);
  const Vec3 left = glm::normalize(glm::cross(glm::cross(b - a, c - a), side));
  return {glm::dot(down, side), glm::dot(down, left)};
}

Condition make_triangle_condition(const WovenTriangle& triangle) {
  Condition condition;
  condition.count = 3;
  for (std::size_t i = 0; i < 3; ++i) condition.vertices[i] = triangle.corners[i];
  return condition;
}

/// Doubled area vectors of a hinge's triangles.
struct HingeNormals {
  Vec3 first, second;
};

HingeNormals hinge_normals(const Hinge& hinge, std::span<const Vec3> p) {
  const auto [a, b, c, d] = hinge.vertices;
  return {glm::cross(p[a] - p[c], p[b] - p[c]), glm::cross(p[b] - p[d], p[a] - p[d])};
}

double hinge_angle_rad(const Hinge& hinge, std::span<const Vec3> p) {
  const HingeNormals n = hinge_normals(hinge, p);
  const Vec3 edge = p[hinge.vertices[1]] - p[hinge.vertices[0]];
  const double sine = glm::dot(glm::cross(n.first, n.second), edge) / glm::length(edge);
  return 2.0 * std::numbers::pi * atan2_turns(sine, glm::dot(n.first, n.second));
}

Index third_corner(const Triangle& triangle, const Edge& edge) {
  return triangle[0] + triangle[1] + triangle[2] - edge[0] - edge[1];
}

double product(std::span<const Vec3> a, std::span<const Vec3> b) {
  assert(a.size() == b.size());
  double sum = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += glm::dot(a[v], b[v]);
  return sum;
}

/// Returns the inverse diagonal blocks; 0 for vertices that are not free.
std::vector<Mat3> preconditioner(const BlockMatrix& a, std::span<const double> inverse_masses_per_kg) {
  std::vector<Mat3> inverses(inverse_masses_per_kg.size(), Mat3(0.0));
  for (std::size_t v = 0; v < inverses.size(); ++v) {
    if (inverse_masses_per_kg[v] > 0.0) inverses[v] = glm::inverse(a.diagonal(static_cast<Index>(v)));
  }
  return inverses;
}

void apply(const std::vector<Mat3>& blocks, std::span<const Vec3> vector, std::span<Vec3> result) {
  assert(blocks.size() == vector.size());
  assert(vector.size() == result.size());
  for (std::size_t v = 0; v < blocks.size(); ++v) result[v] = blocks[v] * vector[v];
}

/// y += factor x
void add(double factor, std::span<const Vec3> x, std::span<Vec3> y) {
  assert(x.size() == y.size());
  for (std::size_t v = 0; v < x.size(); ++v) y[v] += factor * x[v];
}

}  // namespace

std::vector<WovenTriangle> woven_triangles(const Garment& garment) {
  std::vector<WovenTriangle> woven;
  for (std::size_t t = 0; t < garment.mesh.triangles.size(); ++t) {
    const TriangleAtRest& rest = garment.triangles_at_rest[t];
    if (!rest.has_surface()) continue;
    WovenTriangle triangle;
    triangle.corners = garment.mesh.triangles[t];
    triangle.root_area_m = std::sqrt(0.5 / (rest.along_per_m * rest.across_per_m));
    const Vec2 warp = triangle_warp(garment, t);
    const std::array<Vec2, 3> columns = gradients_by_corners(rest);
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.along_warp[i] = warp.x * columns[i].x + warp.y * columns[i].y;
      triangle.along_weft[i] = warp.x * columns[i].y - warp.y * columns[i].x;
    }
    woven.push_back(triangle);
  }
  return woven;
}

std::vector<Hinge> hinges(const Garment& garment) {
  std::vector<Hinge> all;
  const Mesh& mesh = garment.mesh;
  for (std::size_t e = 0; e < garment.adjacency.edges.size(); ++e) {
    const std::span<const Index> sides = garment.adjacency.edge_triangles[e];
    if (sides.size() != 2 || !garment.triangles_at_rest[sides[0]].has_surface() ||
        !garment.triangles_at_rest[sides[1]].has_surface()) {
      continue;
    }
    const Edge& edge = garment.adjacency.edges[e];
    Hinge hinge;
    hinge.vertices = {edge[0], edge[1], third_corner(mesh.triangles[sides[0]], edge),
                      third_corner(mesh.triangles[sides[1]], edge)};
    const HingeNormals n = hinge_normals(hinge, mesh.positions);
    const Vec3 along = mesh.positions[edge[1]] - mesh.positions[edge[0]];
    hinge.rest_angle_rad = hinge_angle_rad(hinge, mesh.positions);
    hinge.shape = 2.0 * glm::dot(along, along) / (glm::length(n.first) + glm::length(n.second));
    all.push_back(hinge);
  }
  return all;
}

Vec3 derivative(const WovenTriangle& triangle, const std::array<double, 3>& weights,
                std::span<const Vec3> positions_m) {
  const auto [a, b, c] = corner_positions(triangle.corners, positions_m);
  return weights[1] * (b - a) + weights[2] * (c - a);
}

Condition spring_condition(const Edge& ends, double rest_length_m, std::span<const Vec3> positions_m) {
  Condition condition;
  condition.count = 2;
  condition.vertices = {ends[0], ends[1]};
  const Vec3 spring = positions_m[ends[0]] - positions_m[ends[1]];
  const double length_m = glm::length(spring);
  condition.value = length_m - rest_length_m;
  if (!(length_m > 0.0)) return condition;
  const Vec3 direction = spring / length_m;
  condition.gradients = {direction, -direction};
  condition.weights = {1.0, -1.0};
  condition.curvature = (Mat3(1.0) - glm::outerProduct(direction, direction)) / length_m;
  return condition;
}

Condition stretch_condition(const WovenTriangle& triangle, const std::array<double, 3>& weights,
                            std::span<const Vec3> positions_m) {
  Condition condition = make_triangle_condition(triangle);
  const Vec3 w = derivative(triangle, weights, positions_m);
  const double length = glm::length(w);
  condition.value = triangle.root_area_m * (length - 1.0);
  if (!(length > 0.0)) return condition;
  const Vec3 direction = w / length;
  condition.curvature = (triangle.root_area_m / length) * (Mat3(1.0) - glm::outerProduct(direction, direction));
  for (std::size_t i = 0; i < 3; ++i) {
    condition.gradients[i] = triangle.root_area_m * weights[i] * direction;
    condition.weights[i] = weights[i];
  }
  return condition;
}

Condition shear_condition(const WovenTriangle& triangle, std::span<const Vec3> positions_m) {
  Condition condition = make_triangle_condition(triangle);
  const Vec3 warp = derivative(triangle, triangle.along_warp, positions_m);
  const Vec3 weft = derivative(triangle, triangle.along_weft, positions_m);
  condition.value = triangle.root_area_m * glm::dot(warp, weft);
  for (std::size_t i = 0; i < 3; ++i) {
    condition.gradients[i] = triangle.root_area_m * (triangle.along_warp[i] * weft + triangle.along_weft[i] * warp);
  }
  return condition;
}

Condition bend_condition(const Hinge& hinge, std::span<const Vec3> p) {
  Condition condition;
  condition.count = 4;
  condition.vertices = hinge.vertices;
  const auto [a, b, c, d] = hinge.vertices;
  const HingeNormals n = hinge_normals(hinge, p);
  const Vec3 edge = p[b] - p[a];
  const double length_m = glm::length(edge);
  const double first = glm::dot(n.first, n.first);
  const double second = glm::dot(n.second, n.second);
  if (!(first > 0.0) || !(second > 0.0) || !(length_m > 0.0)) return condition;
  const double bent_rad = hinge_angle_rad(hinge, p) - hinge.rest_angle_rad;
  constexpr double turn_rad = 2.0 * std::numbers::pi;
  condition.value = bent_rad - turn_rad * std::round(bent_rad / turn_rad);
  // Derivatives of a dihedral angle, as in Bridson, Marino and Fedkiw (2003), section 4.
  const Vec3 by_c = -n.first * (length_m / first);
  const Vec3 by_d = -n.second * (length_m / second);
  const double share_c = glm::dot(p[c] - p[a], edge) / (length_m * length_m);
  const double share_d = glm::dot(p[d] - p[a], edge) / (length_m * length_m);
  condition.gradients = {-(1.0 - share_c) * by_c - (1.0 - share_d) * by_d, -share_c * by_c - share_d * by_d, by_c,
                         by_d};
  return condition;
}

BlockMatrix::BlockMatrix(std::size_t vertex_count, std::span<const Edge> pairs) {
  std::vector<std::vector<Index>> rows(vertex_count);
  for (Index v = 0; v < vertex_count; ++v) rows[v].push_back(v);
  for (const Edge& pair : pairs) {
    rows[pair[0]].push_back(pair[1]);
    rows[pair[1]].push_back(pair[0]);
  }
  columns_.offsets.push_back(0);
  for (Index v = 0; v < vertex_count; ++v) {
    std::sort(rows[v].begin(), rows[v].end());
    rows[v].erase(std::unique(rows[v].begin(), rows[v].end()), rows[v].end());
    const auto diagonal = std::find(rows[v].begin(), rows[v].end(), v) - rows[v].begin();
    diagonals_.push_back(columns_.items.size() + static_cast<std::size_t>(diagonal));
    columns_.items.insert(columns_.items.end(), rows[v].begin(), rows[v].end());
    columns_.offsets.push_back(static_cast<Index>(columns_.items.size()));
  }
  blocks_.resize(columns_.items.size());
}

void BlockMatrix::clear() { std::fill(blocks_.begin(), blocks_.end(), Mat3(0.0)); }

Mat3& BlockMatrix::at(Index row, Index column) {
  const std::span<const Index> columns = columns_[row];
  const auto found = std::lower_bound(columns.begin(), columns.end(), column);
  assert(found != columns.end() && *found == column);
  return blocks_[columns_.offsets[row] + static_cast<std::size_t>(found - columns.begin())];
}

void BlockMatrix::multiply(std::span<const Vec3> vector, std::span<Vec3> product) const {
  assert(vector.size() == columns_.size() && product.size() == columns_.size());
  for (std::size_t row = 0; row < columns_.size(); ++row) {
    Vec3 sum(0.0);
    for (std::size_t at = columns_.offsets[row]; at < columns_.offsets[row + 1]; ++at) {
      sum += blocks_[at] * vector[columns_.items[at]];
    }
    product[row] = sum;
  }
}

void add_inertia(std::span<const double> masses_kg, std::span<const Vec3> forces_n, double air_drag_per_s,
                 const System& system) {
  assert(masses_kg.size() == forces_n.size());
  assert(air_drag_per_s >= 0.0);
  const double h = system.time_step_s;
  for (Index v = 0; v < masses_kg.size(); ++v) {
    system.matrix.at(v, v) += Mat3(masses_kg[v] * (1.0 + h * air_drag_per_s));
    system.right_side[v] += h * forces_n[v];
  }
}

void add_condition(const Condition& condition, const Stiffness& stiffness, const System& system) {
  const double h = system.time_step_s, k = stiffness.k;
  const double d = stiffness.damping_s * k;
  double rate = 0.0;       // dC/dt
  Vec3 weighted_sum(0.0);  // weighted sum of velocities
  const auto count = static_cast<std::size_t>(condition.count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& velocity = system.velocities_m_per_s[condition.vertices[i]];
    rate += glm::dot(condition.gradients[i], velocity);
    weighted_sum += condition.weights[i] * velocity;
  }
  const double tension = k * condition.value + d * rate;
  const Mat3 curvature = std::max(tension, 0.0) * condition.curvature;
  const Vec3 bent = curvature * weighted_sum;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& gradient = condition.gradients[i];
    const Vec3 force = -tension * gradient;
    const Vec3 force_change = -k * rate * gradient - condition.weights[i] * bent;  // df/dx v
    system.right_side[condition.vertices[i]] += h * (force + h * force_change);
    for (std::size_t j = 0; j < count; ++j) {
      system.matrix.at(condition.vertices[i], condition.vertices[j]) +=
          (h * d + h * h * k) * glm::outerProduct(gradient, condition.gradients[j]) +
          (h * h * condition.weights[i] * condition.weights[j]) * curvature;
    }
  }
}

int solve(const BlockMatrix& a, std::span<const Vec3> b, std::span<const double> inverse_masses_per_kg,
          double tolerance, std::span<Vec3> x) {
  assert(b.size() == x.size() && inverse_masses_per_kg.size() == x.size());
  const std::vector<Mat3> inverses = preconditioner(a, inverse_masses_per_kg);
  std::vector<Vec3> residual(x.size()), search(x.size()), image(x.size()), preconditioned(x.size());
  // r = b - A x; the preconditioner filters, so r needs no filter.
  a.multiply(x, image);
  residual.assign(b.begin(), b.end());
  add(-1.0, image, residual);
  apply(inverses, residual, search);
  double error = product(residual, search);
  const double min_error = tolerance * tolerance * error;
  const int max_iterations = 3 * static_cast<int>(x.size());
  int iteration = 0;
  for (; iteration < max_iterations && error > min_error; ++iteration) {
    a.multiply(search, image);
    const double step = error / product(search, image);
    add(step, search, x);
    add(-step, image, residual);
    apply(inverses, residual, preconditioned);
    const double before = error;
    error = product(residual, preconditioned);
    for (std::size_t v = 0; v < search.size(); ++v) {
      search[v] = preconditioned[v] + (error / before) * search[v];
    }
  }
  return iteration;
}

void predict(const Frame& frame, double time_step_s, double tolerance, const AddConditions& add_conditions,
             BlockMatrix& matrix, State& state) {
  assert(time_step_s > 0.0);
  assert(tolerance > 0.0);
  const std::size_t count = state.current.size();
  std::vector<Vec3> velocities(count), forces_n(count), right_side(count), changes(count);
  for (Index v = 0; v < count; ++v) velocities[v] = velocity(state, v);
  matrix.clear();
  const System system = {time_step_s, velocities, matrix, right_side};
  const ExternalForces& external = frame.surroundings.forces;
  add_external_forces(frame.garment, state, external, frame.wind_fractions, time_step_s, forces_n);
  add_inertia(frame.garment.masses_kg, forces_n, external.air_drag_per_s, system);
  add_conditions(state, system);

  state.predicted = state.current;
  move_pins(frame.pins, frame.surroundings, time_step_s, state);
  for (const Index pin : frame.pins.vertices) {
    changes[pin] = (state.predicted[pin] - state.current[pin]) / time_step_s - velocities[pin];
  }
  solve(matrix, right_side, frame.pins.inverse_masses_per_kg, tolerance, changes);
  for (std::size_t v = 0; v < count; ++v) {
    if (frame.pins.inverse_masses_per_kg[v] > 0.0) {
      state.predicted[v] += time_step_s * (velocities[v] + changes[v]);
    }
  }
}

}  // namespace taut::sim::implicit
