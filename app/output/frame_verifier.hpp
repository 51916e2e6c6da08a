#pragma once

#include "app/models/scene_crossings.hpp"
#include "app/output/frame_record.hpp"
#include "app/verify/stretch.hpp"

namespace taut::app {

/// Says by how much which bound of the solver is exceeded. Returns an empty text if none is, if the solver
/// has none or if the scene accepts more (solver.allow_exceeding).
std::string describe_excess(const LargestStretch& stretch, const sim::SolverSettings& solver);

/// Holds frames to both promises, by the code of app/verify, which shares nothing with the solvers: no
/// triangle of the cloth crosses another one or a body, whatever the scene allows, and the solver's bound is
/// kept (describe_excess).
class FrameVerifier {
 public:
  /// Call it first, with the simulation at its start. Pairs that cross there are left out until they
  /// are apart in a frame that is checked; so are, in each frame, pairs of two triangles of one group of what
  /// the solver leaves out (sim::LeftOutTriangle). Returns what crosses, for people; empty: nothing.
  ///
  /// A resumed run has the start of the whole run, before the checkpoint: a pair that crosses
  /// where the run is resumed counts unless it crossed at that start. That a pair was apart in the meantime
  /// is not known.
  std::string begin(const sim::Simulation& simulation);

  /// Checks the present shape and counts its crossing pairs in the record: pairs of triangles, and a pair for
  /// each triangle in a body that is no mesh, without those that are left out. Bodies are taken where they
  /// are at the record's time. Returns what is broken, with frame, time, triangles, vertices and place;
  /// empty: nothing.
  std::string check(const sim::Simulation& simulation, FrameRecord& record);

  int frames() const { return frames_; }
  /// Returns the largest stretch of all frames that were checked.
  const LargestStretch& largest() const { return largest_; }

  /// Returns a line about all frames that were checked, none of which was broken.
  std::string summary() const;

 private:
  std::vector<SceneCrossings> left_out_;
  std::size_t crossing_at_start_ = 0;
  std::size_t crossing_at_end_ = 0;  ///< in the last frame that was checked, whatever is left out
  int frames_ = 0;
  LargestStretch largest_;
};

}  // namespace taut::app
