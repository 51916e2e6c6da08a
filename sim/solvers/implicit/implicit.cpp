#include "sim/solvers/implicit/implicit.hpp"

#include "sim/measures.hpp"

namespace taut::sim {
namespace {

using namespace implicit;

/// Successful steps before a longer one is tried. Higher values try less often.
constexpr int successes_to_double = 2;

std::vector<Edge> coupled_pairs(const Garment& garment, std::span<const Hinge> hinges) {
  std::vector<Edge> pairs = garment.adjacency.edges;
  for (const Hinge& hinge : hinges) {
    const auto [a, b, c, d] = hinge.vertices;
    pairs.push_back({c, d});
  }
  return pairs;
}

}  // namespace

ImplicitSolver::ImplicitSolver(const ImplicitSettings& settings, std::optional<int> substeps, int max_substeps)
    : settings_(settings),
      substeps_(substeps),
      max_halvings_(std::bit_width(static_cast<unsigned>(max_substeps)) - 1) {}

void ImplicitSolver::prepare(const Garment& garment) {
  if (triangles_.empty()) {
    triangles_ = woven_triangles(garment);
    hinges_ = hinges(garment);
    matrix_ = BlockMatrix(garment.mesh.positions.size(), coupled_pairs(garment, hinges_));
  }
}

void ImplicitSolver::predict(const Frame& frame, double time_step_s, State& state) {
  assert(time_step_s > 0.0);
  const double damping_s = settings_.damping_s;
  const auto add_conditions = [&](const State& now, const System& system) {
    for (const WovenTriangle& triangle : triangles_) {
      for (const auto& weights : {triangle.along_warp, triangle.along_weft}) {
        add_condition(stretch_condition(triangle, weights, now.current), {settings_.stretch_n_per_m, damping_s},
                      system);
      }
      add_condition(shear_condition(triangle, now.current), {settings_.shear_n_per_m, damping_s}, system);
    }
    for (const Hinge& hinge : hinges_) {
      const double rigidity = frame.garment.material.bending_rigidity_n_m * hinge.shape;
      add_condition(bend_condition(hinge, now.current), {rigidity, damping_s}, system);
    }
  };
  implicit::predict(frame, time_step_s, settings_.tolerance, add_conditions, matrix_, state);
}

bool ImplicitSolver::stretch_changes_too_much(const State& state) const {
  if (first_lost(state.predicted) < state.predicted.size()) return true;
  for (const WovenTriangle& triangle : triangles_) {
    for (const auto& weights : {triangle.along_warp, triangle.along_weft}) {
      const double before = glm::length(derivative(triangle, weights, state.current));
      const double after = glm::length(derivative(triangle, weights, state.predicted));
      if (std::abs(after - before) > settings_.max_stretch_change) return true;
    }
  }
  return false;
}

/// Advances one frame with adaptive steps. Returns the number of steps.
int ImplicitSolver::adapt(const Frame& frame, State& state) {
  const int parts = 1 << max_halvings_;
  int steps = 0;
  next_halvings_ = halvings_;
  int successes = 0;  // successful steps of the present length in this frame
  for (int done = 0; done < parts;) {
    frame.ask();
    const int length = parts >> next_halvings_;
    const double time_step_s = frame.duration_s * length / parts;
    predict(frame, time_step_s, state);
    if (next_halvings_ < max_halvings_ && stretch_changes_too_much(state)) {
      ++next_halvings_;
      successes = 0;
      continue;
    }
    finish_step(frame.garment, frame.pins, frame.surroundings, time_step_s, state);
    done += length;
    ++steps;
    successes = std::min(successes + 1, successes_to_double);
    // A longer step begins only at a multiple of its own length.
    if (successes == successes_to_double && next_halvings_ > 0 && done % (2 * length) == 0) {
      --next_halvings_;
      successes = 0;
    }
  }
  return steps;
}

FrameReport ImplicitSolver::advance_frame(const Frame& frame, State& state) {
  prepare(frame.garment);
  FrameReport report;
  if (!substeps_) {
    report.substeps = adapt(frame, state);
    return report;
  }
  report.substeps = *substeps_;
  const double time_step_s = frame.duration_s / report.substeps;
  for (int step = 0; step < report.substeps; ++step) {
    frame.ask();
    predict(frame, time_step_s, state);
    finish_step(frame.garment, frame.pins, frame.surroundings, time_step_s, state);
  }
  return report;
}

void ImplicitSolver::save(const Garment&, const Pins&, ByteWriter& memory) const { memory.put(halvings_); }

void ImplicitSolver::restore(const Frame&, ByteReader& memory) {
  halvings_ = next_halvings_ = memory.get("how often the time step is halved", 0, max_halvings_);
}

}  // namespace taut::sim
