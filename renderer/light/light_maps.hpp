#pragma once

#include "renderer/gl/gl_objects.hpp"

namespace taut::renderer {

/// What one of many passes samples: a place in the pixel, a point of the key lamp, and directions of the sky.
struct PassSample {
  glm::vec2 pixel_offset;                             ///< from the middle of the pixel, -0.5 to 0.5
  glm::vec2 lamp_point;                               ///< on the unit disc
  std::array<glm::vec3, sky_pair_count> towards_sky;  ///< unit, upwards; each stands for its opposite too
};

/// Returns the samples of pass `index` of `count`. Heights of the sky's directions are spread evenly over all passes
/// (Hammersley 1960); everything else follows an additive recurrence in five dimensions (Roberts, "The unreasonable
/// effectiveness of quasirandom sequences", 2018).
PassSample make_pass_sample(int index, int count);

/// Returns a view from a light: the matrix from world to clip space, where depth grows away from the light.
/// `world_to_map` maps to 0..1; `lower`: seen from the other end.
glm::mat4 light_view(const glm::mat4& world_to_map, bool lower);

/// Depth maps of one pass, drawn by OpenGL as layers of one texture; see shaders/light_maps.glsl.
class LightMaps {
 public:
  /// The context must be current and outlive this object.
  explicit LightMaps(const GladGLContext& context);
  /// Binds an empty layer as the framebuffer. All layers have a side of side_px.
  void begin(int layer, int side_px);
  /// Binds the maps to light_maps_unit.
  void bind() const;

  static constexpr int layer_count = 1 + 2 * static_cast<int>(sky_pair_count);

 private:
  const GladGLContext* gl_;
  std::optional<Texture> maps_;
  Framebuffer framebuffer_;
  Sampler compare_;
  int side_px_ = 0;
};

}  // namespace taut::renderer
