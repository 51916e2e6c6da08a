#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/base/job_runner.hpp"

namespace taut::app {

/// How a model maps to springs.
struct Mapping {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t structural = 0;
  std::size_t flexural = 0;
  std::size_t loose_vertices = 0;  ///< that no spring holds
};

/// What a solver made of a garment that was let go.
struct TrialRun {
  double largest_stretch = 0.0;  ///< of all frames; not finite where the run diverged
  double median_ms = 0.0;        ///< of a frame, while other experiments ran
};

/// A model read from a file, mapped and simulated.
struct GarmentTrial {
  std::string file;
  std::string kind;     ///< what is particular about it
  std::string refusal;  ///< why it could not be read or mapped; then nothing below is set
  Mapping mapping;
  TrialRun strong;   ///< the paper's method: equation (3) in full
  TrialRun bounded;  ///< asked for `trial_bound`
};

inline constexpr int trial_frames = 45;
// The solver's own where nothing is said.
inline constexpr int trial_steps = 20;
inline constexpr int trial_sweeps = 4;
inline constexpr double trial_bound = 0.05;

/// Any model file: read as every command reads it, hung by its top, simulated with both solvers.
GarmentTrial try_garment(const std::string& file, const std::string& kind, const Checkpoint& checkpoint);

/// Writes sample garments in their formats, and tries them and the three shirts.
std::vector<GarmentTrial> try_garments(const Checkpoint& checkpoint);

}  // namespace taut::app
