#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace taut::renderer {

/// A part of a square map, in its pixels.
struct MapArea {
  glm::ivec2 lower{0};
  glm::ivec2 upper{0};  ///< not included
};

/// A square depth map, drawn on the processor: its triangles are a few pixels large, and so many that setting
/// them up for a general rasteriser costs several times what filling them here does.
class DepthMap {
 public:
  /// Depth 1, the farthest, everywhere.
  void resize(int side_px);
  /// Forgets what was drawn.
  void clear();
  /// Keeps the least depth at every pixel centre; `world_to_map` leads to 0..1 in all three axes. What falls
  /// outside is left out.
  void draw(const glm::mat4& world_to_map, std::span<const glm::vec3> positions,
            std::span<const std::uint32_t> triangles);

  int side_px() const { return side; }
  /// `place` is 0..1 within the map, outside it nothing is drawn.
  float depth_at(const glm::vec2& place) const;
  /// What has been drawn to since the last clear().
  const MapArea& drawn() const { return drawn_area; }
  /// Row by row from the bottom, as OpenGL takes textures.
  std::span<const float> depths() const { return texels; }

 private:
  void include(const std::vector<glm::vec3>& points);

  int side = 0;
  MapArea drawn_area;
  std::vector<float> texels;
  std::vector<glm::vec3> projected;  // scratch: x and y in pixels, z the depth
};

/// Points in pixels of a map of side_px, z in 0..1, into `projected`.
void project_to_map(const glm::mat4& world_to_map, int side_px, std::span<const glm::vec3> positions,
                    std::vector<glm::vec3>& projected);

}  // namespace taut::renderer
