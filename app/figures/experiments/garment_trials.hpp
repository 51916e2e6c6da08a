#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/base/job_runner.hpp"

namespace taut::app {

/// How a model maps to springs: the number of each.
struct Mapping {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t structural = 0;      ///< springs
  std::size_t flexural = 0;        ///< springs
  std::size_t loose_vertices = 0;  ///< vertices without a spring
};

/// The result of one solver on a garment that starts as it was modelled.
struct TrialRun {
  double largest_stretch = 0.0;  ///< of all frames, a fraction; not finite if the run diverged
  double median_ms = 0.0;        ///< per frame; other experiments ran at the same time
};

/// A model that was read, mapped to springs and simulated.
struct GarmentTrial {
  std::string file;
  std::string kind;     ///< what is special about it
  std::string refusal;  ///< Why it could not be read or mapped. If not empty, the members below are not set.
  Mapping mapping;
  TrialRun strong;   ///< the paper's method, with equation (3) in full
  TrialRun bounded;  ///< with the bound trial_bound
};

/// Frames of each trial.
inline constexpr int trial_frames = 45;
// The solver's own where nothing is said.
inline constexpr int trial_steps = 20;
inline constexpr int trial_sweeps = 4;
/// Bound on stretch for `bounded`, a fraction.
inline constexpr double trial_bound = 0.05;

/// Reads a model file as every command does, hangs it by its top and simulates it with both solvers.
GarmentTrial try_garment(const std::string& file, const std::string& kind,
                         const ProgressCallback& report_progress);

/// Writes the sample garments to files, and tries them and the three shirts.
std::vector<GarmentTrial> try_garments(const ProgressCallback& report_progress);

}  // namespace taut::app
