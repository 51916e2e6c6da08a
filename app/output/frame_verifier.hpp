#pragma once

#include <string>
#include <vector>

#include "app/output/frame_record.hpp"
#include "sim/contact/colliders.hpp"

namespace taut::app {

/// Holds frames to both promises, by the code of app/verify, which shares nothing with the solvers: no
/// triangle of the cloth crosses another one or a body, and nothing is longer than the bound, where the
/// solver has one and the scene does not accept more (solver.allow_exceeding).
class FrameVerifier {
 public:
  /// Checks the present shape and counts its crossing pairs in the record: pairs of triangles, and a pair for
  /// each triangle in a body that is no mesh. Returns what is broken, with frame, time, triangles, vertices
  /// and place; empty: nothing.
  std::string check(const sim::Simulation& simulation, FrameRecord& record);

  /// Returns a line about all frames that were checked, none of which was broken.
  std::string summary() const;

 private:
  int frames_ = 0;
  double largest_springs_ = -1.0;
  double largest_surface_ = -1.0;
};

}  // namespace taut::app
