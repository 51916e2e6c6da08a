#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace taut::renderer {

/// Square depth maps side by side, drawn on the processor. A map of the sky shows a garment's triangles a
/// pixel or two large, and so many of them that setting them up for a general rasteriser costs several times
/// what filling them here does.
class DepthAtlas {
 public:
  DepthAtlas(int columns, int rows, int cell_px);

  /// Forgets everything drawn: depth 1, the farthest, everywhere.
  void clear();
  /// Keeps the least depth at every pixel centre of a cell; `world_to_cell` leads to 0..1 in all three axes.
  /// What falls outside the cell is left out.
  void draw(int cell, const glm::mat4& world_to_cell, std::span<const glm::vec3> positions,
            std::span<const std::uint32_t> triangles);

  int width_px() const { return columns * cell_px; }
  int height_px() const { return rows * cell_px; }
  /// Of the first cell; `place` is 0..1 within it, outside it nothing is drawn.
  float depth_at(const glm::vec2& place) const;
  /// Row by row from the bottom, as OpenGL takes textures.
  std::span<const float> depths() const { return texels; }

 private:
  void fill(float* corner, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

  int columns;
  int rows;
  int cell_px;
  std::vector<float> texels;
  std::vector<glm::vec3> projected;  // scratch: x and y in pixels of the cell, z its depth
};

}  // namespace taut::renderer
