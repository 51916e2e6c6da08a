#pragma once

#include "renderer/frame_view.hpp"

namespace taut::renderer {

/// Ambient light with occlusion: bright from above, weaker from below, reduced by what stands in the way.
/// Occlusion is tested along pairs of opposite directions. A small map per pair holds the nearest and the
/// farthest depth of the casters.
class SkyLight {
 public:
  /// Draws the maps of the casters, which lie in `box` (metres). directions: as
  /// PictureSettings::sky_directions. No box or 0 directions: nothing is occluded.
  void draw_maps(std::span<const SurfaceView* const> casters, const std::optional<Box>& box, int directions);

  /// Fills `light` with one pair per vertex: the light on its outside (x) and inside (y), relative to an
  /// unoccluded side that faces straight up.
  void gather(const SurfaceView& surface, std::vector<glm::vec2>& light);

  /// Fills `light` with the share of the sky that each spot of the floor sees, 0 to 1: floor_px rows of
  /// floor_px values. `area`: FrameBlock::ground_light_area; height_m: y of the floor.
  void gather_floor(const glm::vec4& area, float height_m, std::vector<float>& light);

  /// Side of the floor's light texture, texels. Its contents are smooth; larger costs time.
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

  std::vector<Pair> pairs_;
  float lift_m_ = 0.0F;
  float cone_tangent_ = 0.0F;
  std::vector<glm::vec3> projected_;  // scratch
  std::vector<float> sums_;           // scratch: of what a pair's map blocks, from its corner
};

}  // namespace taut::renderer
