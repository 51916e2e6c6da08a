#include "tests/study/reference/incremental_potential.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace reference {
namespace {

/// Stiffness of the barrier, at which cloth at rest is about a tenth of the barrier's reach within it.
constexpr double barrier_n_per_m = 1000.0;
/// Squared sine below which edges count as parallel (Li, Ferguson and others 2020 use the same).
constexpr double parallel_squared_sine = 1e-3;

using Gradient = Eigen::Matrix<double, 12, 1>;
using Hessian = Eigen::Matrix<double, 12, 12>;

std::array<Point, 4> points_at(const Vector& x, const std::array<int, 4>& vertices) {
  return {at(x, vertices[0]), at(x, vertices[1]), at(x, vertices[2]), at(x, vertices[3])};
}

/// Value of a function of one variable, with its derivatives.
struct Taylor {
  double value, first, second;
};

/// Returns -(d - reach)^2 ln (d / reach) with its derivatives (Li, Ferguson and others 2020, eq. 6).
Taylor barrier(double d, double reach) {
  const double short_of = d - reach, log = std::log(d / reach);
  return {-short_of * short_of * log, -short_of * (2.0 * log + short_of / d),
          -2.0 * log - 4.0 * short_of / d + short_of * short_of / (d * d)};
}

/// Angle between two triangles, 0 when flat, with its gradient.
struct Angle {
  double angle;
  Gradient gradient;
};

Angle compute_angle(const std::array<Point, 4>& x) {
  const Point edge = x[1] - x[0];
  const double length = edge.norm();
  const Point first = (x[2] - x[0]).cross(x[2] - x[1]), second = (x[3] - x[1]).cross(x[3] - x[0]);
  const Point n1 = first / first.squaredNorm(), n2 = second / second.squaredNorm();
  Angle result{std::atan2(second.cross(first).dot(edge) / length, first.dot(second)), {}};
  const auto along = [&](int i, int end) { return (x[i] - x[end]).dot(edge) / length; };
  result.gradient << along(2, 1) * n1 + along(3, 1) * n2, -along(2, 0) * n1 - along(3, 0) * n2, length * n1,
      length * n2;
  return result;
}

/// Returns the derivatives of the angle's gradient, by differences.
Hessian curvature_of_angle(const std::array<Point, 4>& x) {
  const double step = 1e-5 * (x[1] - x[0]).norm();
  Hessian hessian;
  for (int k = 0; k < 12; ++k) {
    std::array<Point, 4> ahead = x, behind = x;
    ahead[k / 3][k % 3] += step;
    behind[k / 3][k % 3] -= step;
    hessian.col(k) = (compute_angle(ahead).gradient - compute_angle(behind).gradient) / (2.0 * step);
  }
  return 0.5 * (hessian + hessian.transpose());
}

/// Returns the derivatives by the four vertices as blocks, each a number times the identity.
Eigen::Matrix<double, 3, 12> blocks(const Eigen::Vector4d& weights) {
  Eigen::Matrix<double, 3, 12> all;
  for (int i = 0; i < 4; ++i) all.block<3, 3>(0, 3 * i) = weights[i] * Eigen::Matrix3d::Identity();
  return all;
}

Gradient together(const std::array<Point, 4>& x) {
  Gradient all;
  all << x[0], x[1], x[2], x[3];
  return all;
}

Gradient gradient_of_square(const Closest& closest, const Gradient& points) {
  const Eigen::Matrix<double, 3, 12> whole = blocks(closest.weights);
  return 2.0 * whole.transpose() * (whole * points);
}

/// Returns the second derivatives of the squared distance. Free parameters follow the vertices.
Hessian hessian_of_square(const Closest& closest, const Gradient& points) {
  const Eigen::Matrix<double, 3, 12> whole = blocks(closest.weights);
  const Point way = whole * points;
  Hessian hessian = 2.0 * whole.transpose() * whole;
  const int n = closest.free_count;
  if (n == 0) return hessian;
  Eigen::MatrixXd mixed(12, n), own(3, n);
  for (int k = 0; k < n; ++k) {
    const Eigen::Matrix<double, 3, 12> change = blocks(closest.free[k]);
    own.col(k) = change * points;
    mixed.col(k) = 2.0 * (change.transpose() * way + whole.transpose() * own.col(k));
  }
  const Eigen::MatrixXd free = 2.0 * own.transpose() * own;
  hessian -= mixed * free.inverse() * mixed.transpose();
  return hessian;
}

/// Squared doubled area that two edges span, with its derivatives.
struct Span {
  double value;
  Gradient gradient;
  Hessian hessian;
};

Span compute_span(const std::array<Point, 4>& x) {
  const Point u = x[1] - x[0], v = x[3] - x[2];
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  Eigen::Matrix<double, 6, 1> gradient;
  gradient << 2.0 * (vv * u - uv * v), 2.0 * (uu * v - uv * u);
  Eigen::Matrix<double, 6, 6> hessian;
  hessian.block<3, 3>(0, 0) = 2.0 * (vv * one - v * v.transpose());
  hessian.block<3, 3>(3, 3) = 2.0 * (uu * one - u * u.transpose());
  hessian.block<3, 3>(0, 3) = 2.0 * (2.0 * u * v.transpose() - v * u.transpose() - uv * one);
  hessian.block<3, 3>(3, 0) = hessian.block<3, 3>(0, 3).transpose();
  Eigen::Matrix<double, 6, 12> edges = Eigen::Matrix<double, 6, 12>::Zero();
  edges.block<3, 3>(0, 0) = edges.block<3, 3>(3, 6) = -one;
  edges.block<3, 3>(0, 3) = edges.block<3, 3>(3, 9) = one;
  return {uu * vv - uv * uv, edges.transpose() * gradient, edges.transpose() * hessian * edges};
}

/// Fades the barrier between nearly parallel edges, where its second derivatives would jump (Li, Ferguson and others
/// 2020, section 5.2).
void fade(const std::array<Point, 4>& x, double parallel_below_m4, Local& local) {
  const Span span = compute_span(x);
  if (span.value >= parallel_below_m4) return;
  const double part = span.value / parallel_below_m4;
  const double faded = part * (2.0 - part), slope = 2.0 * (1.0 - part) / parallel_below_m4;
  const Gradient fading = slope * span.gradient;
  const Hessian change =
      slope * span.hessian - 2.0 / (parallel_below_m4 * parallel_below_m4) * span.gradient * span.gradient.transpose();
  local.hessian = (faded * local.hessian + local.energy * change + local.gradient * fading.transpose() +
                   fading * local.gradient.transpose())
                      .eval();
  local.gradient = faded * local.gradient + local.energy * fading;
  local.energy *= faded;
}

void project(Local& local) {
  const int n = 3 * local.count;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(local.hessian.topLeftCorner(n, n));
  const Eigen::VectorXd kept = solver.eigenvalues().cwiseMax(0.0);
  local.hessian.topLeftCorner(n, n) = solver.eigenvectors() * kept.asDiagonal() * solver.eigenvectors().transpose();
}

/// Box around vertices during a step.
struct Box {
  Point low, high;

  bool is_beside(const Box& other) const {
    return (low.array() > other.high.array()).any() || (other.low.array() > high.array()).any();
  }
};

template <class Vertices> Box box_around(const Vertices& vertices, const Vector& x, const Vector& by, double room_m) {
  Box box{Point::Constant(std::numeric_limits<double>::infinity()),
          Point::Constant(-std::numeric_limits<double>::infinity())};
  for (const int v : vertices) {
    for (const Point& p : {at(x, v), Point(at(x, v) + at(by, v))}) {
      box.low = box.low.cwiseMin(p);
      box.high = box.high.cwiseMax(p);
    }
  }
  box.low.array() -= room_m;
  box.high.array() += room_m;
  return box;
}

bool shares(const auto& some, const auto& others) {
  return std::any_of(some.begin(), some.end(),
                     [&](int v) { return std::find(others.begin(), others.end(), v) != others.end(); });
}

}  // namespace

Point at(const Vector& x, int vertex) { return x.segment<3>(3 * vertex); }

Vector flatten(const std::vector<Point>& points) {
  Vector x(3 * static_cast<Eigen::Index>(points.size()));
  for (std::size_t v = 0; v < points.size(); ++v) x.segment<3>(3 * static_cast<Eigen::Index>(v)) = points[v];
  return x;
}

Potential::Potential(Cloth cloth)
    : cloth_(std::move(cloth)), is_pinned_(cloth_.rest_m.size(), 0), masses_kg_(cloth_.rest_m.size(), 0.0) {
  for (const int pin : cloth_.pins) is_pinned_[pin] = 1;
  for (const Corners& t : cloth_.triangles) {
    const Point a = cloth_.rest_m[t[1]] - cloth_.rest_m[t[0]], b = cloth_.rest_m[t[2]] - cloth_.rest_m[t[0]];
    const double area = 0.5 * a.cross(b).norm();
    areas_m2_.push_back(area);
    for (const int v : t) masses_kg_[v] += cloth_.fabric.density_kg_per_m2 * area / 3.0;
    Eigen::Matrix2d flat;  // the triangle's edges in its own plane
    flat << a.norm(), a.dot(b) / a.norm(), 0.0, 2.0 * area / a.norm();
    const Eigen::Matrix2d inverse = flat.inverse();
    shape_.emplace_back();
    shape_.back() << -inverse.colwise().sum(), inverse;
  }
  find_hinges();
}

// A sheet with this stiffness has its bending rigidity on equilateral triangles, and on right-angled triangles along
// their legs (Seung and Nelson 1988). With a third of the area, as hinges are often written, it would be three times as
// stiff.
// stiff.
void Potential::find_hinges() {
  std::map<std::array<int, 2>, std::vector<std::size_t>> triangles_at;
  for (std::size_t t = 0; t < cloth_.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = cloth_.triangles[t][k], b = cloth_.triangles[t][(k + 1) % 3];
      triangles_at[{std::min(a, b), std::max(a, b)}].push_back(t);
    }
  }
  const auto across = [&](std::size_t t, const std::array<int, 2>& edge) {
    return *std::find_if(cloth_.triangles[t].begin(), cloth_.triangles[t].end(),
                         [&](int v) { return v != edge[0] && v != edge[1]; });
  };
  for (const auto& [edge, beside] : triangles_at) {
    edges_.push_back(edge);
    if (beside.size() != 2) continue;
    const double squared_length = (cloth_.rest_m[edge[1]] - cloth_.rest_m[edge[0]]).squaredNorm();
    hinges_.push_back({{edge[0], edge[1], across(beside[0], edge), across(beside[1], edge)},
                       cloth_.fabric.rigidity_n_m * squared_length / (areas_m2_[beside[0]] + areas_m2_[beside[1]])});
  }
}

// Neo-Hookean with a Poisson's ratio of 0: energy = area stiffness / 4 (tr C - 2 - ln det C), C = F^T F.
Local Potential::stretch_of(const Vector& x, std::size_t triangle, bool has_hessian) const {
  Local local;
  local.count = 3;
  Eigen::Matrix<double, 3, 2> f = Eigen::Matrix<double, 3, 2>::Zero();
  for (int i = 0; i < 3; ++i) {
    local.vertices[i] = cloth_.triangles[triangle][i];
    f += at(x, local.vertices[i]) * shape_[triangle].row(i);
  }
  const Eigen::Matrix2d c = f.transpose() * f, inverse = c.inverse();
  const double factor = 0.5 * areas_m2_[triangle] * cloth_.fabric.stiffness_n_per_m;
  local.energy = 0.5 * factor * (c.trace() - 2.0 - std::log(c.determinant()));
  const Eigen::Matrix<double, 3, 2> stress = factor * (f - f * inverse);
  for (int i = 0; i < 3; ++i) local.gradient.segment<3>(3 * i) = stress * shape_[triangle].row(i).transpose();
  for (int k = 0; has_hessian && k < 9; ++k) {
    const Eigen::Matrix<double, 3, 2> df = Point::Unit(k % 3) * shape_[triangle].row(k / 3);
    const Eigen::Matrix2d dc = df.transpose() * f + f.transpose() * df;
    const Eigen::Matrix<double, 3, 2> change = factor * (df - df * inverse + f * inverse * dc * inverse);
    for (int i = 0; i < 3; ++i) {
      local.hessian.block<3, 1>(3 * i, k) = change * shape_[triangle].row(i).transpose();
    }
  }
  return local;
}

Local Potential::bend_of(const Vector& x, std::size_t hinge, bool has_hessian) const {
  const Hinge& h = hinges_[hinge];
  const std::array<Point, 4> points = points_at(x, h.vertices);
  const Angle angle = compute_angle(points);
  Local local{h.vertices, 4};
  local.energy = 0.5 * h.stiffness * angle.angle * angle.angle;
  local.gradient = h.stiffness * angle.angle * angle.gradient;
  if (!has_hessian) return local;
  local.hessian = h.stiffness * (angle.gradient * angle.gradient.transpose());
  local.hessian += h.stiffness * angle.angle * curvature_of_angle(points);
  return local;
}

Local Potential::barrier_of(const Vector& x, const Pair& pair, bool has_hessian) const {
  Local local{pair.vertices, 4};
  const std::array<Point, 4> points = points_at(x, pair.vertices);
  const Closest closest = find_closest(pair, points);
  const double distance = std::sqrt(closest.squared_m2);
  const double reach = cloth_.fabric.thickness_m;
  if (distance - pair.offset_m >= reach) return local;
  if (distance <= pair.offset_m) {
    local.energy = std::numeric_limits<double>::infinity();
    return local;
  }
  const Gradient all = together(points);
  const Gradient square = gradient_of_square(closest, all);
  const Taylor b = barrier(distance - pair.offset_m, reach);
  const double per_square = b.first / (2.0 * distance);
  local.energy = b.value;
  local.gradient = per_square * square;
  if (has_hessian) {
    local.hessian = per_square * hessian_of_square(closest, all) +
                    (b.second - b.first / distance) / (4.0 * closest.squared_m2) * square * square.transpose();
  }
  if (pair.is_of_edges) fade(points, pair.parallel_below_m4, local);
  local.energy *= barrier_n_per_m;
  local.gradient *= barrier_n_per_m;
  local.hessian *= barrier_n_per_m;
  return local;
}

std::vector<Pair> Potential::pairs_near(const Vector& x, const Vector& by) const {
  const double room_m = 0.5 * cloth_.fabric.thickness_m;
  std::vector<Pair> pairs;
  std::vector<Box> points, triangles, edges;
  for (int v = 0; v < static_cast<int>(vertex_count()); ++v) {
    const double own_m = v == cloth_.ball ? cloth_.ball_radius_m : 0.0;
    points.push_back(box_around(std::array{v}, x, by, room_m + own_m));
  }
  for (const auto& t : cloth_.triangles) triangles.push_back(box_around(t, x, by, room_m));
  for (const auto& e : edges_) edges.push_back(box_around(e, x, by, room_m));
  for (int v = 0; v < static_cast<int>(points.size()); ++v) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const Corners& corners = cloth_.triangles[t];
      if (points[v].is_beside(triangles[t]) || shares(std::array{v}, corners)) continue;
      pairs.push_back({{v, corners[0], corners[1], corners[2]}, false, v == cloth_.ball ? cloth_.ball_radius_m : 0.0});
    }
  }
  std::vector<std::size_t> order(edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t e, std::size_t f) { return edges[e].low.x() < edges[f].low.x(); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t e = order[i];
    for (std::size_t j = i + 1; j < order.size() && edges[order[j]].low.x() <= edges[e].high.x(); ++j) {
      const std::size_t f = order[j];
      if (edges[e].is_beside(edges[f]) || shares(edges_[e], edges_[f])) continue;
      const auto [a, b] = edges_[e];
      const auto [c, d] = edges_[f];
      const double squares =
          (cloth_.rest_m[b] - cloth_.rest_m[a]).squaredNorm() * (cloth_.rest_m[d] - cloth_.rest_m[c]).squaredNorm();
      pairs.push_back({{a, b, c, d}, true, 0.0, parallel_squared_sine * squares});
    }
  }
  return pairs;
}

template <class Use> void Potential::for_each(const Vector& x, bool has_hessian, const Use& use) const {
  for (std::size_t t = 0; t < cloth_.triangles.size(); ++t) use(stretch_of(x, t, has_hessian), &Energies::stretch);
  for (std::size_t h = 0; h < hinges_.size(); ++h) use(bend_of(x, h, has_hessian), &Energies::bend);
  for (const Pair& pair : pairs_near(x, Vector::Zero(x.size())))
    use(barrier_of(x, pair, has_hessian), &Energies::barrier);
}

Energies Potential::energies(const Vector& x) const {
  Energies sum;
  for_each(x, false, [&](const Local& local, double Energies::*part) { sum.*part += local.energy; });
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    sum.weight += masses_kg_[v] * cloth_.gravity_m_per_s2 * at(x, static_cast<int>(v)).y();
  }
  return sum;
}

Vector Potential::gradient(const Vector& x) const {
  Vector gradient = Vector::Zero(x.size());
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    gradient[3 * static_cast<Eigen::Index>(v) + 1] = masses_kg_[v] * cloth_.gravity_m_per_s2;
  }
  for_each(x, false, [&](const Local& local, double Energies::*) {
    for (int i = 0; i < local.count; ++i) {
      gradient.segment<3>(3 * local.vertices[i]) += local.gradient.segment<3>(3 * i);
    }
  });
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    if (is_pinned_[v] != 0) gradient.segment<3>(3 * static_cast<Eigen::Index>(v)).setZero();
  }
  return gradient;
}

Matrix Potential::hessian(const Vector& x, bool is_projected) const {
  std::vector<Eigen::Triplet<double>> entries;
  for_each(x, true, [&](Local local, double Energies::*) {
    if (local.energy == 0.0 && local.hessian.isZero(0.0)) return;
    if (is_projected) project(local);
    for (int row = 0; row < 3 * local.count; ++row) {
      for (int column = 0; column < 3 * local.count; ++column) {
        const int v = local.vertices[row / 3], w = local.vertices[column / 3];
        if (is_pinned_[v] == 0 && is_pinned_[w] == 0) {
          entries.emplace_back(3 * v + row % 3, 3 * w + column % 3, local.hessian(row, column));
        }
      }
    }
  });
  for (int k = 0; k < x.size(); ++k) {
    entries.emplace_back(k, k, is_pinned_[k / 3] != 0 ? 1.0 : 0.0);
  }
  Matrix hessian(x.size(), x.size());
  hessian.setFromTriplets(entries.begin(), entries.end());
  return hessian;
}

double Potential::max_step(const Vector& x, const Vector& by) const {
  double step = 1.0;
  for (const Pair& pair : pairs_near(x, by)) {
    step = std::min(step, step_that_keeps_apart(pair, points_at(x, pair.vertices), points_at(by, pair.vertices)));
  }
  return step;
}

}  // namespace reference
