#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "renderer/camera.hpp"
#include "renderer/frame_view.hpp"

namespace taut::renderer {

/// Light from the whole studio around: bright from above, weaker from below, reduced by what stands in the
/// way. It is tested along pairs of opposite directions; one small map for each pair holds where the casters
/// begin and where they end.
class SkyLight {
 public:
  /// Draws the maps; without a box around casters, or without directions, nothing stands in the way.
  void look(std::span<const SurfaceView* const> casters, const std::optional<Box>& box, int directions);

  /// For each position the share of the light that arrives: x outside, y inside; 1 for a side that faces an
  /// open sky.
  void gather(const SurfaceView& surface, std::vector<glm::vec2>& light);

  /// Shares of the sky that spots of the floor see, row by row: floor_px squared over the area of
  /// FrameBlock::ground_light_area.
  void gather_floor(const glm::vec4& area, float height_m, std::vector<float>& light);

  /// Side of the floor's light texture; its contents are smooth.
  static constexpr int floor_px = 56;

 private:
  struct Pair {
    glm::vec3 towards{0.0F};  // the upper of the two
    glm::mat4 world_to_map{1.0F};
    std::vector<float> nearest;
    std::vector<float> farthest;
  };
  void draw(Pair& pair, std::span<const SurfaceView* const> casters);
  void gather_pair(const Pair& pair, const SurfaceView& surface, std::vector<glm::vec2>& light) const;
  void sum_up(const Pair& pair, float height_m);
  float floor_blocked(const glm::vec2& texel, float radius_px) const;

  std::vector<Pair> pairs;
  float lift_m = 0.0F;
  float cone_tangent = 0.0F;
  std::vector<glm::vec3> projected;  // scratch
  std::vector<float> sums;           // scratch: of what a pair's map blocks, from its corner
};

}  // namespace taut::renderer
