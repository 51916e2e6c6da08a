#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "renderer/light/surface_tables.hpp"

namespace taut::renderer {

/// Which squares of a tile surfaces can touch: a software rasteriser shades pixels where nothing is to be
/// seen as slowly as others, so only these are shaded.
class CoveredSquares {
 public:
  /// Looks at all triangles of the tables; `world_to_clip` is the tile's, its size is in drawn pixels.
  void find(const SurfaceTables& tables, const glm::mat4& world_to_clip, const glm::ivec2& size_px);

  /// Corners of triangles in clip space that cover the squares in which some triangle is open to the key
  /// light's shadow, or those in which all are decided.
  const std::vector<glm::vec2>& corners(bool open);

  /// Side of a square, drawn pixels. Smaller fits closer, and is more to draw.
  static constexpr int side_px = 16;

 private:
  void mark(const glm::ivec4& box, std::uint8_t kind);
  void mark_all();
  void add_run(int first, int end, int row);

  glm::ivec2 tile_px{0};
  glm::ivec2 squares{0};
  std::vector<std::uint8_t> kinds;   // of each square: nothing, decided or open
  std::vector<glm::vec3> projected;  // scratch: pixels, z: 0 behind the eye
  std::vector<glm::vec2> triangles;  // scratch
};

}  // namespace taut::renderer
