#include "sim/solvers/fast_projection/fast_projection.hpp"

#include "sim/mesh/preconditions.hpp"

#include <Eigen/SparseCholesky>

namespace taut::sim {
namespace {

/// Addition to the diagonal, as a fraction of its value at rest. Larger values take smaller, safer steps in nearly
/// singular systems; smaller values take fewer projections where lengths can be kept.
constexpr double regularisation = 1e-6;

using Matrix = Eigen::SparseMatrix<double>;

/// Returns the lower triangle; the entries of a column are in row order.
Matrix make_pattern(std::span<const Edge> edges, std::size_t vertex_count) {
  const CompressedRows at_vertex = at_vertices(vertex_count, edges);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t column = 0; column < edges.size(); ++column) {
    entries.emplace_back(static_cast<int>(column), static_cast<int>(column), 1.0);
    for (const Index end : edges[column]) {
      for (const Index row : at_vertex[end]) {
        if (row > column) entries.emplace_back(static_cast<int>(row), static_cast<int>(column), 0.0);
      }
    }
  }
  const auto size = static_cast<int>(edges.size());
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Index shared_end(const Edge& a, const Edge& b) { return a[0] == b[0] || a[0] == b[1] ? a[0] : a[1]; }

constexpr int default_steps = 5;

/// Tolerance of the linear system without the constraint, see implicit::solve.
constexpr double tolerance = 1e-4;

}  // namespace

// Eigen computes the factors entry by entry, in the same order with every compiler.
struct LengthSystem::Factors {
  Matrix matrix;
  Eigen::SimplicialLDLT<Matrix> solver;
  Eigen::VectorXd errors_m;
};

LengthSystem::LengthSystem(std::span<const Edge> edges, std::span<const double> rest_lengths_m, const Pins& pins)
    : inverse_masses_per_kg_(pins.inverse_masses_per_kg), factors_(std::make_unique<Factors>()) {
  assert(edges.size() == rest_lengths_m.size());
  assert(are_below(edges, pins.inverse_masses_per_kg.size()));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (inverse_masses_per_kg_[edges[e][0]] + inverse_masses_per_kg_[edges[e][1]] > 0.0) {
      edges_.push_back(edges[e]);
      rest_lengths_m_.push_back(rest_lengths_m[e]);
    }
  }
  factors_->matrix = make_pattern(edges_, inverse_masses_per_kg_.size());
  factors_->solver.analyzePattern(factors_->matrix);
  factors_->errors_m.resize(static_cast<Eigen::Index>(edges_.size()));
}

LengthSystem::~LengthSystem() = default;

double LengthSystem::find_max_strain(std::span<const Vec3> positions_m) const {
  double found_strain = 0.0;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const double length_m = glm::distance(positions_m[edges_[e][0]], positions_m[edges_[e][1]]);
    found_strain = std::max(found_strain, std::abs(length_m / rest_lengths_m_[e] - 1.0));
  }
  return found_strain;
}

/// Returns the derivative of C by the position of one end.
Vec3 LengthSystem::gradient(std::size_t edge, Index end, std::span<const Vec3> positions_m) const {
  const Vec3 away = positions_m[end] - positions_m[other_end(edges_[edge], end)];
  return away * (2.0 / rest_lengths_m_[edge]);
}

/// Fills grad C M^-1 grad C^T; two edges share at most one vertex.
void LengthSystem::fill(std::span<const Vec3> positions_m) {
  for (int column = 0; column < factors_->matrix.outerSize(); ++column) {
    const auto c = static_cast<std::size_t>(column);
    for (Matrix::InnerIterator entry(factors_->matrix, column); entry; ++entry) {
      const auto r = static_cast<std::size_t>(entry.row());
      if (r == c) {
        const Vec3 along = gradient(c, edges_[c][0], positions_m);
        const double w = inverse_masses_per_kg_[edges_[c][0]] + inverse_masses_per_kg_[edges_[c][1]];
        entry.valueRef() = w * (glm::dot(along, along) + 4.0 * regularisation);
      } else {
        const Index v = shared_end(edges_[r], edges_[c]);
        entry.valueRef() =
            inverse_masses_per_kg_[v] * glm::dot(gradient(r, v, positions_m), gradient(c, v, positions_m));
      }
    }
  }
}

bool LengthSystem::project(std::span<Vec3> positions_m) {
  assert(positions_m.size() == inverse_masses_per_kg_.size());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Vec3 edge = positions_m[edges_[e][1]] - positions_m[edges_[e][0]];
    factors_->errors_m[static_cast<Eigen::Index>(e)] = glm::dot(edge, edge) / rest_lengths_m_[e] - rest_lengths_m_[e];
  }
  fill(positions_m);
  factors_->solver.factorize(factors_->matrix);
  if (factors_->solver.info() != Eigen::Success) return false;
  // The multipliers are h^2 dl; the time step cancels.
  const Eigen::VectorXd multipliers = factors_->solver.solve(factors_->errors_m);
  if (!multipliers.allFinite()) return false;
  std::vector<Vec3> moved_m(positions_m.size(), Vec3(0.0));
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    for (const Index end : edges_[e]) {
      moved_m[end] -=
          gradient(e, end, positions_m) * (inverse_masses_per_kg_[end] * multipliers[static_cast<Eigen::Index>(e)]);
    }
  }
  for (std::size_t v = 0; v < positions_m.size(); ++v) positions_m[v] += moved_m[v];
  return true;
}

FastProjectionSolver::FastProjectionSolver(const FastProjectionSettings& settings, std::optional<int> substeps)
    : settings_(settings), substeps_(substeps.value_or(default_steps)) {}

void FastProjectionSolver::prepare(const Garment& garment, const Pins& pins) {
  if (lengths_ && pinned_ == pins.vertices) return;
  const std::size_t count = garment.springs.end_index(SpringKind::structural);
  lengths_ = std::make_unique<LengthSystem>(std::span(garment.springs.ends).first(count),
                                            std::span(garment.springs.rest_lengths_m).first(count), pins);
  matrix_ = implicit::BlockMatrix(garment.mesh.positions.size(), garment.springs.ends);
  pinned_ = pins.vertices;
}

void FastProjectionSolver::predict(const Frame& frame, double time_step_s, State& state) {
  assert(time_step_s > 0.0);
  const Springs& springs = frame.garment.springs;
  const auto add_springs = [&](const State& now, const implicit::System& system) {
    for (const SpringKind kind : {SpringKind::shear, SpringKind::flexural}) {
      const double k = spring_stiffness(kind, settings_.stiffness);
      if (!(k > 0.0)) continue;
      for (std::size_t s = springs.begin_index(kind); s < springs.end_index(kind); ++s) {
        add_condition(implicit::spring_condition(springs.ends[s], springs.rest_lengths_m[s], now.current),
                      {k, settings_.stiffness.damping_n_s_per_m / k}, system);
      }
    }
  };
  implicit::predict(frame, time_step_s, tolerance, add_springs, matrix_, state);
}

void FastProjectionSolver::project(std::span<Vec3> predicted_m) {
  for (int projection = 0; projection < settings_.max_projections; ++projection) {
    const bool is_kept = lengths_->find_max_strain(predicted_m) <= settings_.max_strain;
    if ((is_kept && projection > 0) || !lengths_->project(predicted_m)) return;
  }
}

FrameReport FastProjectionSolver::advance_frame(const Frame& frame, State& state) {
  prepare(frame.garment, frame.pins);
  const double time_step_s = frame.duration_s / substeps_;
  for (int step = 0; step < substeps_; ++step) {
    frame.ask();
    predict(frame, time_step_s, state);
    project(state.predicted);
    finish_step(frame.garment, frame.pins, frame.surroundings, time_step_s, state);
  }
  FrameReport report;
  report.substeps = substeps_;
  return report;
}

}  // namespace taut::sim
