#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/gl/frame_block.hpp"
#include "renderer/light/depth_map.hpp"

namespace taut::renderer {

/// What of the key light reaches a triangle; the numbers are those of shaders/tables.glsl.
enum class KeyLight : std::uint8_t {
  shadow = 0,
  light = 1,
  open = 2,  ///< pixels have to find out
};

/// Which triangles lie wholly in the key light or wholly in its shadow: their pixels need not look into the
/// shadow map, which is what most of a picture's time would go into. A triangle is compared with the map
/// wherever it lies in it; around those that are partly in the shadow, penumbrae spread along the mesh.
class KeyDecision {
 public:
  /// `map` shows the casters as the light sees them, `block` says where; the map has to outlive the
  /// decisions.
  void look(const DepthMap& map, const FrameBlock& block);
  /// One for each triangle of the surface.
  void decide(const SurfaceView& surface, std::vector<KeyLight>& decided);

 private:
  // How much of a triangle the light sees.
  struct Sight {
    int lit = 0;              // texels
    int dark = 0;             // texels
    float widest_gap = 0.0F;  // between the triangle and what is in front of it; share of the map's depth
  };
  using Corners = std::span<const std::uint32_t, 3>;

  Sight sight_of(Corners corners) const;
  void compare(const SurfaceView& surface, std::vector<KeyLight>& decided);
  void find_edges(std::span<const std::uint32_t> triangles, const std::vector<KeyLight>& decided);
  void spread(const SurfaceView& surface);
  float penumbra_m(float gap) const;

  const DepthMap* map = nullptr;
  glm::mat4 world_to_map{1.0F};
  float side_m = 0.0F;      // 0: nothing casts a shadow
  float softness_m = 0.0F;  // widest blur
  float sharpest_m = 0.0F;  // narrowest blur
  float tangent = 0.0F;     // of the light's angular radius
  // Scratch.
  std::vector<glm::vec3> projected;   // x and y in samples, z the depth
  std::vector<float> penumbrae_m;     // of each triangle with shadow on it
  std::vector<std::uint8_t> touched;  // by light (1) and shadow (2), for each vertex
  std::vector<float> reaches_m;       // how far a penumbra still goes from each vertex
};

}  // namespace taut::renderer
