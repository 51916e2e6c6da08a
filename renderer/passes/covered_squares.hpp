#pragma once

#include "renderer/gl/frame_block.hpp"
#include "renderer/light/surface_buffers.hpp"

namespace taut::renderer {

/// Returns the bounds of surfaces and marks in the picture, rounded outwards to blocks of 32 pixels. Zero
/// wide when there are none. `world_to_clip` is that of the whole picture. `surfaces`: the frame's surfaces
/// and the meshes of its spheres.
Tile screen_bounds(const FrameView& frame, std::span<const SurfaceView> surfaces, const glm::mat4& world_to_clip,
                   const PictureSettings& settings);

/// Returns whether any surface or mark has a point below y = height_m, metres.
bool reaches_below(float height_m, const FrameView& frame, std::span<const SurfaceView> surfaces);

/// The squares of a tile's grid that surfaces can touch. Only these are shaded: a software rasteriser takes
/// as long for a pixel without a surface as for any other.
class CoveredSquares {
 public:
  /// Marks the squares that the bounding rectangles of the triangles touch. `world_to_clip` is that of the
  /// tile, size_px its size in drawn pixels.
  void find(const SurfaceBuffers& surfaces, const glm::mat4& world_to_clip, const glm::ivec2& size_px);

  /// Returns the corners, three per triangle, of triangles in clip space that cover the marked squares: those
  /// with a triangle of KeyVisibility::partial, or else those without. Valid until the next call.
  const std::vector<glm::vec2>& corners(bool partial);

  /// Side of a square, drawn pixels. Smaller shades fewer pixels without a surface, but draws more squares.
  static constexpr int side_px = 16;

 private:
  void mark(const glm::ivec4& box, std::uint8_t kind);
  void mark_all();
  void add_run(int first, int end, int row);

  glm::ivec2 tile_px_{0};
  glm::ivec2 squares_{0};
  std::vector<std::uint8_t> kinds_;   // of each square: no surface, uniform or partial shadow
  std::vector<glm::vec3> projected_;  // scratch: pixels, z: 0 behind the eye
  std::vector<glm::vec2> triangles_;  // scratch
};

}  // namespace taut::renderer
