#pragma once

#include <glm/mat4x4.hpp>
#include <span>

#include "renderer/gl_objects.hpp"
#include "renderer/shader.hpp"
#include "renderer/surface_buffers.hpp"

namespace taut::renderer {

using Casters = std::span<const SurfaceBuffers* const>;

/// Two ways to read a depth map: how much of a neighbourhood is farther than a value, and the depth itself.
/// Outside the map nothing is in the way.
struct DepthSamplers {
  explicit DepthSamplers(const GladGLContext& gl);
  Sampler compare;
  Sampler plain;
};

/// Depth as the key light sees it.
class ShadowPass {
 public:
  ShadowPass(const GladGLContext& context, std::span<const ShaderFile> files);

  /// Draws the casters into a square map of side_px; `world_to_shadow` leads to 0..1 in all axes. Without
  /// casters the map is clear.
  void draw(Casters casters, const glm::mat4& world_to_shadow, int side_px);

  const Texture& texture() const { return map; }

 private:
  const GladGLContext* gl;
  Program depth;
  Texture map;
  Framebuffer framebuffer;
  int allocated_px = 0;
};

}  // namespace taut::renderer
