#include "sim/solvers/implicit/system.hpp"

namespace taut::sim::implicit {

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
  const double h = system.time_step_s;
  for (Index v = 0; v < masses_kg.size(); ++v) {
    system.matrix.at(v, v) += Mat3(masses_kg[v] * (1.0 + h * air_drag_per_s));
    system.right_side[v] += h * forces_n[v];
  }
}

void add_condition(const Condition& condition, const Stiffness& stiffness, const System& system) {
  const double h = system.time_step_s;
  const double k = stiffness.k;
  const double d = stiffness.damping_s * k;
  double rate = 0.0;       // dC/dt
  Vec3 weighted_sum(0.0);  // of velocities
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

namespace {

double product(std::span<const Vec3> a, std::span<const Vec3> b) {
  double sum = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += glm::dot(a[v], b[v]);
  return sum;
}

/// The inverse diagonal blocks, filtered: 0 at vertices that are not free.
std::vector<Mat3> preconditioner(const BlockMatrix& a, std::span<const double> inverse_masses_per_kg) {
  std::vector<Mat3> inverses(inverse_masses_per_kg.size(), Mat3(0.0));
  for (std::size_t v = 0; v < inverses.size(); ++v) {
    if (inverse_masses_per_kg[v] > 0.0) inverses[v] = glm::inverse(a.diagonal(static_cast<Index>(v)));
  }
  return inverses;
}

void apply(const std::vector<Mat3>& blocks, std::span<const Vec3> vector, std::span<Vec3> result) {
  for (std::size_t v = 0; v < blocks.size(); ++v) result[v] = blocks[v] * vector[v];
}

/// y += factor x
void add(double factor, std::span<const Vec3> x, std::span<Vec3> y) {
  for (std::size_t v = 0; v < x.size(); ++v) y[v] += factor * x[v];
}

}  // namespace

int solve(const BlockMatrix& a, std::span<const Vec3> b, std::span<const double> inverse_masses_per_kg,
          double tolerance, std::span<Vec3> x) {
  assert(b.size() == x.size() && inverse_masses_per_kg.size() == x.size());
  const std::vector<Mat3> inverses = preconditioner(a, inverse_masses_per_kg);
  std::vector<Vec3> residual(x.size()), search(x.size()), image(x.size()), preconditioned(x.size());
  // r = b - A x; the preconditioner filters, so that r itself need not be.
  a.multiply(x, image);
  residual.assign(b.begin(), b.end());
  add(-1.0, image, residual);
  apply(inverses, residual, search);
  double error = product(residual, search);
  const double least = tolerance * tolerance * error;
  const int most = 3 * static_cast<int>(x.size());
  int iteration = 0;
  for (; iteration < most && error > least; ++iteration) {
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
  const std::size_t count = state.current.size();
  std::vector<Vec3> velocities(count), forces_n(count), right_side(count), changes(count);
  for (Index v = 0; v < count; ++v) velocities[v] = velocity(state, v);
  matrix.clear();
  const System system = {time_step_s, velocities, matrix, right_side};
  const ExternalForces& external = frame.surroundings.forces;
  add_external_forces(frame.garment, state, external, time_step_s, forces_n);
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
