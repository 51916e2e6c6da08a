#pragma once

#include "app/scene/scene.hpp"
#include "app/sewing/cutting.hpp"

namespace taut::app {

/// Pieces that are sewn together as far as they are.
struct SewnPieces {
  sim::Garment garment;               ///< its mesh lies where it is now, and is at rest as it was cut
  std::vector<sim::Index> vertex_of;  ///< per vertex of the pieces, that of the garment
  /// The stitch of the seam that is furthest from being closed, and how far its sides are apart at most, in
  /// m; 0 where all are closed.
  std::size_t open_stitch = 0;
  double gap_m = 0.0;
  sim::Vec3 gap_place_m = sim::Vec3(0.0);
  std::string reason = {};  ///< what is in the way
};

/// Called before the first frame and in every frame, with what share of the vertices of seams are sewn, and with the
/// pieces as they are joined and lie.
using SewingReport =
    std::function<void(double share, const sim::Garment& garment, const std::vector<sim::Vec3>& positions_m)>;

/// Draws the seams of pieces together that begin where they are placed, among the bodies of the scene as they
/// are at `time_s`, without gravity: each vertex of a seam is pulled to the middle of those that it is sewn
/// to, by a thread with limited force, and the solver keeps both promises. Vertices that have come together become one
/// vertex where nothing crosses by that. Ends when all is closed, or nothing closes any more. Throws
/// Interrupted.
SewnPieces close_seams(const CutPieces& pieces, const Scene& scene, double time_s, const SewingReport& report = {});

}  // namespace taut::app
