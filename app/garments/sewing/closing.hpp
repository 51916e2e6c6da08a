#pragma once

#include "app/garments/dressing/dressing.hpp"
#include "app/garments/sewing/cutting.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// Pieces whose closed seams are joined.
struct SewnPieces {
  sim::Garment garment;               ///< garment whose mesh lies where it is now, and whose rest lengths are as cut
  std::vector<sim::Index> vertex_of;  ///< per vertex of the pieces, its vertex in the garment
  /// Stitch with the widest gap, and this gap in m; 0 if all stitches are closed.
  std::size_t open_stitch = 0;
  double gap_m = 0.0;
  sim::Vec3 gap_place_m = sim::Vec3(0.0);
  std::string reason = {};  ///< reason why the gap stays open
};

/// Callback before the first frame and after every frame, with the joined fraction of the seams' vertices, and with the
/// joined pieces and their positions.
using SewingReport =
    std::function<void(double share, const sim::Garment& garment, const std::vector<sim::Vec3>& positions_m)>;

/// Draws the seams of placed pieces together, without gravity, among the bodies at `time_s`. A
/// thread with limited force pulls each vertex of a seam to the middle of the vertices that it is sewn to, and the
/// solver keeps both promises. Vertices that have met are joined unless this makes something cross. Ends when all seams
/// are closed or no more of them close. Throws Interrupted.
SewnPieces close_seams(const CutPieces& pieces, const Scene& scene, const LoadedBodies& bodies, double time_s,
                       const SewingReport& report = {});

}  // namespace taut::app
