#pragma once

#include <string>

#include "app/output/frame_record.hpp"
#include "app/verify/stretch.hpp"

namespace taut::app {

/// Says by how much which bound of the solver is exceeded. Returns an empty text if none is, if the solver
/// has none or if the scene accepts more (solver.allow_exceeding).
std::string describe_excess(const LargestStretch& stretch, const sim::SolverSettings& solver);

/// Holds frames to both promises, by the code of app/verify, which shares nothing with the solvers: no
/// triangle of the cloth crosses another one or a body, and the solver's bound is kept (describe_excess).
class FrameVerifier {
 public:
  /// Checks the present shape and counts its crossing pairs in the record: pairs of triangles, and a pair for
  /// each triangle in a body that is no mesh. Bodies are taken where they are at the record's time. Returns
  /// what is broken, with frame, time, triangles, vertices and place; empty: nothing.
  std::string check(const sim::Simulation& simulation, FrameRecord& record);

  /// Returns a line about all frames that were checked, none of which was broken.
  std::string summary() const;

 private:
  int frames_ = 0;
  LargestStretch largest_;
};

}  // namespace taut::app
