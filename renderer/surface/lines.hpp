#pragma once

#include "renderer/frame_view.hpp"
#include "renderer/surface/smooth_surface.hpp"

namespace taut::renderer {

/// Edges of a mesh as chains, such as borders and seams. Chains end at vertices where not exactly two edges meet.
struct LineChains {
  struct ChainSegment {
    VertexPair ends;     ///< ends in the direction of the chain
    float start = 0.0F;  ///< position along the chain, in the unit of positions
    std::uint32_t chain = 0;
  };
  struct Chain {
    std::uint32_t first_segment = 0;
    std::uint32_t segment_count = 0;
    float length = 0.0F;
    bool is_closed = false;
  };
  std::vector<ChainSegment> segments;  ///< segments chain by chain, in order
  std::vector<Chain> chains;
};

/// Orders edges into chains.
LineChains make_lines(std::span<const VertexPair> edges, std::span<const glm::vec3> rest_positions);

/// Nearest point on lines of a vertex.
struct NearestOnLine {
  static constexpr std::uint32_t none = ~0U;

  std::uint32_t segment = none;  ///< none if no line is near
  float distance = std::numeric_limits<float>::infinity();
  float along = 0.0F;  ///< position along the chain
};

/// Returns one entry per vertex. Distances spread from triangle to triangle, so that near layers of cloth do not count;
/// they are straight, which is right if `reach` is small compared with folds.
std::vector<NearestOnLine> nearest_on_lines(const LineChains& lines, std::span<const glm::vec3> rest_positions,
                                            std::span<const std::uint32_t> triangles, float reach);

/// Finish of a border.
struct BorderBand {
  float width_m = 0.0F;  ///< width of double cloth; 0: none
  bool ribbed = false;   ///< a knitted band, as at necklines; otherwise a hem
};

/// Sewing details of a mesh.
struct SewingPlan {
  std::span<const BorderBand> bands;  ///< one per coarse vertex; a border uses that of its first vertex
  std::span<const VertexPair> seams;  ///< edges of the coarse mesh
  float stitch_m = 0.004F;            ///< length of a stitch
  float thickness_m = 0.001F;         ///< thickness of the cloth
};

/// Returns the triangles of the surface near its borders and seams, ascending. rest_positions: one per vertex
/// of the surface, in metres.
std::vector<TrimmedTriangle> trimmed_triangles(const SmoothSurface& surface, std::span<const glm::vec3> rest_positions,
                                               const SewingPlan& plan);

}  // namespace taut::renderer
