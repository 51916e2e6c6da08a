#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace taut::renderer {

/// A rectangle of a square map, in texels.
struct MapArea {
  glm::ivec2 lower{0};
  glm::ivec2 upper{0};  ///< excluded
};

/// A square shadow map (Williams 1978), rasterised on the CPU. Garment triangles cover only a few texels, so
/// that their setup in a general rasteriser would cost several times as much.
class ShadowMap {
 public:
  /// Sets the side in texels. A new size clears the map.
  void resize(int side_px);
  /// Sets every texel to depth 1, the farthest.
  void clear();
  /// Rasterises triangles and keeps the least depth at every texel centre. `world_to_map` leads from metres
  /// to 0..1 in all three axes; what falls outside is clipped. `triangles`: three indices into positions
  /// each.
  void draw(const glm::mat4& world_to_map, std::span<const glm::vec3> positions,
            std::span<const std::uint32_t> triangles);

  /// Returns the side in texels.
  int side_px() const { return side_; }
  /// Returns the depth of the texel at `place`, texture coordinates 0..1; 1 outside the map.
  float depth_at(const glm::vec2& place) const;
  /// Returns the bounds of all texels drawn since the last clear().
  const MapArea& drawn() const { return drawn_; }
  /// Returns side_px * side_px depths, lowest row first, as OpenGL takes textures.
  std::span<const float> depths() const { return texels_; }

 private:
  void include(const std::vector<glm::vec3>& points);

  int side_ = 0;
  MapArea drawn_;
  std::vector<float> texels_;
  std::vector<glm::vec3> projected_;  // scratch: x and y in pixels, z the depth
};

/// Fills `projected` with one point per position: x and y in texels of a map of side_px, z the depth, 0..1.
void project_to_map(const glm::mat4& world_to_map, int side_px, std::span<const glm::vec3> positions,
                    std::vector<glm::vec3>& projected);

}  // namespace taut::renderer
