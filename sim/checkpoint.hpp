#pragma once

#include "sim/solvers/solver.hpp"

namespace taut::sim {

/// Everything that has to be saved to go on with the same bits. The garment, its pins, the settings and the
/// surroundings are not in it: they have to be those of the simulation that was saved.
struct Checkpoint {
  State state;                 ///< without `predicted`
  std::vector<Vec3> before_m;  ///< the shape one frame ago, by vertex
  /// The shape at the start of the quiet frames, by vertex; empty if rest is not being judged.
  std::vector<Vec3> quiet_since_m;
  FrameReport report;         ///< of the last frame that was computed
  std::string solver;         ///< the name of the solver
  std::string solver_memory;  ///< see Solver::save
};

/// Returns whether rest is being judged: only then is quiet_since_m needed.
bool is_rest_judged(const State& state);

/// As bytes for a file: what it is and its version, which garment it was made of (numbers of vertices,
/// triangles and springs, and a hash of rest shape, triangles, springs and masses), the checkpoint, and a
/// hash of all of it. Numbers have their lowest byte first.
std::string encode(const Checkpoint& checkpoint, const Garment& garment);

/// The same back. Throws BadBytes, which says where, what was found and what was expected, on bytes that are
/// damaged, cut off, of another version or of another garment; whatever they are, they do no harm.
Checkpoint decode(std::string_view bytes, const Garment& garment);

}  // namespace taut::sim
