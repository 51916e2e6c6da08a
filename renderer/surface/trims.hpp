#pragma once

#include "renderer/frame_view.hpp"
#include "renderer/surface/smooth_surface.hpp"

namespace taut::renderer {

/// The finish of a border.
struct BorderBand {
  float width_m = 0.0F;  ///< in which the cloth is double; 0: none
  bool ribbed = false;   ///< a knitted band, as at necklines; else a hem
};

/// How a mesh is sewn.
struct SewingPlan {
  std::span<const BorderBand> bands;  ///< one per coarse vertex; a border has that of its first one
  std::span<const VertexPair> seams;  ///< coarse edges
  float stitch_m = 0.004F;            ///< from stitch to stitch
  float thickness_m = 0.001F;         ///< of the cloth
};

/// Returns the triangles of the surface near its borders and seams, ascending. rest_positions: one per vertex
/// of the surface, in metres.
std::vector<TrimmedTriangle> trimmed_triangles(const SmoothSurface& surface,
                                               std::span<const glm::vec3> rest_positions,
                                               const SewingPlan& plan);

}  // namespace taut::renderer
