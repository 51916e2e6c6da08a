#pragma once

#include "app/models/inspecting/scene_crossings.hpp"
#include "app/runs/frame_record.hpp"
#include "app/verify/stretch.hpp"

namespace taut::app {

/// Describes which bound of the solver is exceeded and by how much. Empty if none is exceeded, if the solver has no
/// bound or if the scene accepts exceeding it (solver.allow_exceeding).
std::string describe_excess(const LargestStretch& stretch, const sim::SolverSettings& solver);

/// Verifies both promises of frames with app/verify, which shares no code with the solvers: no triangle of the cloth
/// crosses another triangle or a body, even if the scene allows it, and the solver's bound is kept (describe_excess).
class FrameVerifier {
 public:
  /// Records the pairs that cross at the start; call it before the other functions. They do not count until they have
  /// been apart in a checked frame. Pairs within one group that contact leaves out (sim::ExcludedTriangle) do not count
  /// either. Returns a message about all crossings; empty: none.
  ///
  /// For a resumed run, call it at the start of the whole run, before the checkpoint is restored: pairs that cross at
  /// the checkpoint count unless they crossed at that start, because it is unknown whether they were apart in between.
  std::string begin(const sim::Simulation& simulation);

  /// Checks the current shape. The record's crossing pairs become the pairs of triangles that count, plus one for each
  /// triangle inside a body that is not a mesh. Bodies are taken at the record's time. Returns a message about each
  /// broken promise, with frame, time, triangles, vertices and position; empty: none.
  std::string check(const sim::Simulation& simulation, FrameRecord& record);

  int frames() const { return frames_; }
  /// Returns the largest stretch of all checked frames.
  const LargestStretch& largest() const { return largest_; }

  /// Returns a line about all checked frames. None of them may have broken a promise.
  std::string summary() const;

 private:
  std::vector<SceneCrossings> ignored_pairs_;
  std::size_t crossing_at_start_ = 0;
  std::size_t crossing_at_end_ = 0;  ///< all crossings in the last checked frame
  int frames_ = 0;
  LargestStretch largest_;
};

}  // namespace taut::app
