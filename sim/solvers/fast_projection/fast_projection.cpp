#include "sim/solvers/fast_projection/fast_projection.hpp"

namespace taut::sim {
namespace {

constexpr int enough_steps = 5;

/// The tolerance of the linear system without the constraint, see implicit::solve.
constexpr double tolerance = 1e-4;

}  // namespace

FastProjectionSolver::FastProjectionSolver(const FastProjectionSettings& settings,
                                           std::optional<int> substeps)
    : settings_(settings), substeps_(substeps.value_or(enough_steps)) {}

void FastProjectionSolver::prepare(const Garment& garment, const Pins& pins) {
  if (lengths_ && pinned_ == pins.vertices) {
    return;
  }
  const std::size_t count = garment.springs.end_of(SpringKind::structural);
  lengths_ = std::make_unique<LengthSystem>(std::span(garment.springs.ends).first(count),
                                            std::span(garment.springs.rest_lengths_m).first(count), pins);
  matrix_ = implicit::BlockMatrix(garment.mesh.positions.size(), garment.springs.ends);
  pinned_ = pins.vertices;
}

void FastProjectionSolver::predict(const Frame& frame, double time_step_s, State& state) {
  const Springs& springs = frame.garment.springs;
  const auto add_springs = [&](const State& now, const implicit::System& system) {
    for (const SpringKind kind : {SpringKind::shear, SpringKind::flexural}) {
      const double k = stiffness_of(kind, settings_.stiffness);
      if (!(k > 0.0)) {
        continue;
      }
      for (std::size_t s = springs.begin_of(kind); s < springs.end_of(kind); ++s) {
        add_condition(implicit::spring_condition(springs.ends[s], springs.rest_lengths_m[s], now.current),
                      {k, settings_.stiffness.damping_n_s_per_m / k}, system);
      }
    }
  };
  implicit::predict(frame, time_step_s, tolerance, add_springs, matrix_, state);
}

void FastProjectionSolver::project(std::span<Vec3> predicted_m) {
  for (int projection = 0; projection < settings_.most_projections; ++projection) {
    const bool is_kept = lengths_->largest_strain(predicted_m) <= settings_.max_strain;
    if ((is_kept && projection > 0) || !lengths_->project(predicted_m)) {
      return;
    }
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
