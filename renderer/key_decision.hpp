#pragma once

#include <span>
#include <vector>

#include "renderer/depth_map.hpp"
#include "renderer/frame_block.hpp"

namespace taut::renderer {

/// Whether the key light reaches all that is near a vertex. Most triangles lie wholly in the light or in the
/// shadow; when their vertices say so, their pixels need not look into the shadow map, which is what most of
/// a picture's time would go into.
class KeyDecision {
 public:
  /// `map` shows the casters as the light sees them, `block` says where; the map has to outlive the
  /// decisions.
  void look(const DepthMap& map, const FrameBlock& block);
  /// One number for each position: 1 in the light, 0 in the shadow, 0.5 where pixels have to look themselves.
  void decide(const SurfaceView& surface, std::vector<float>& decided);

 private:
  // What stands between a disc of the surface's plane and the light.
  struct Blockers {
    int count = 0;
    float widest_gap = 0.0F;  // share of the map's depth
  };
  Blockers look_around(const glm::vec3& place, const glm::vec2& slope, float radius) const;
  float decide_vertex(const glm::vec3& position, const glm::vec3& normal, float reach_m) const;

  const DepthMap* map = nullptr;
  glm::mat4 world_to_map{1.0F};
  glm::vec3 towards_key{0.0F};
  float side_m = 0.0F;           // 0: nothing casts a shadow
  float softness_m = 0.0F;       // widest blur
  float sharpest_m = 0.0F;       // narrowest blur
  float tangent = 0.0F;          // of the light's angular radius
  std::vector<float> reaches_m;  // scratch
};

}  // namespace taut::renderer
