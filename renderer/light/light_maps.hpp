#pragma once

#include "renderer/gl/gl_objects.hpp"

namespace taut::renderer {

/// Number of directions of the sky in one pass of many, each with its opposite.
inline constexpr std::size_t sky_pairs_of_pass = 2;

/// What one of many passes samples: a place in the pixel, a point of the key lamp, and directions of the sky.
struct PassSample {
  glm::vec2 pixel_offset;                                ///< from the middle of the pixel, -0.5 to 0.5
  glm::vec2 lamp_point;                                  ///< on the unit disc
  std::array<glm::vec3, sky_pairs_of_pass> towards_sky;  ///< unit, upwards; each stands for its opposite too
};

/// Returns the samples of pass `index` of `count`. Heights of the sky's directions are spread evenly over all passes
/// (Hammersley 1960); everything else follows an additive recurrence in five dimensions (Roberts, "The unreasonable
/// effectiveness of quasirandom sequences", 2018).
PassSample make_pass_sample(int index, int count);

/// Depth maps drawn by OpenGL as layers of one texture; see shaders/light_maps.glsl.
class LightMaps {
 public:
  /// The context must be current and outlive this object.
  explicit LightMaps(const GladGLContext& context);
  /// Sets the number of layers and their side; none count as one.
  void resize(int layers, int side_px);
  /// Binds an empty layer as the framebuffer.
  void begin(int layer) const;
  /// Binds the maps to a texture unit, with a sampler that compares depths, or one for the depths themselves.
  void bind(unsigned unit, bool compares) const;

 private:
  const GladGLContext* gl_;
  std::optional<Texture> maps_;
  Framebuffer framebuffer_;
  Sampler compare_;
  Sampler plain_;
  glm::ivec2 shape_{0};  // layers and side
};

}  // namespace taut::renderer
