#pragma once

#include "renderer/frame_view.hpp"
#include "renderer/surface/smooth_surface.hpp"

namespace taut::renderer {

/// Edges of a mesh as chains, such as borders and seams. They part where other than two edges meet.
struct Lines {
  struct Segment {
    VertexPair ends;     ///< in the direction of its chain
    float start = 0.0F;  ///< how far along the chain it starts, in the unit of positions
    std::uint32_t chain = 0;
  };
  struct Chain {
    std::uint32_t first_segment = 0;
    std::uint32_t segment_count = 0;
    float length = 0.0F;
    bool is_closed = false;
  };
  std::vector<Segment> segments;  ///< chain after chain, each in its order
  std::vector<Chain> chains;
};

/// Orders edges into chains.
Lines lines_of(std::span<const VertexPair> edges, std::span<const glm::vec3> rest_positions);

/// Where on some lines a vertex is nearest to them.
struct NearestOnLine {
  static constexpr std::uint32_t none = ~0U;

  std::uint32_t segment = none;  ///< none: no line is near
  float distance = std::numeric_limits<float>::infinity();
  float along = 0.0F;  ///< along its chain
};

/// Returns one entry per vertex. Distances spread from triangle to triangle, so that a layer of cloth
/// that lies near is not near; distances are straight, which is right while `reach` is small beside folds.
std::vector<NearestOnLine> nearest_on_lines(const Lines& lines, std::span<const glm::vec3> rest_positions,
                                            std::span<const std::uint32_t> triangles, float reach);

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
std::vector<TrimmedTriangle> trimmed_triangles(const SmoothSurface& surface, std::span<const glm::vec3> rest_positions,
                                               const SewingPlan& plan);

}  // namespace taut::renderer
