#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "renderer/gl/gl_objects.hpp"
#include "renderer/gl/lazy_program.hpp"

namespace taut::renderer {

/// Averages what was drawn with several samples, or larger, and lays it over the bound framebuffer.
class ResolvePass {
 public:
  ResolvePass(const GladGLContext& context, std::span<const ShaderFile> files);

  /// `drawn` is sRGB-encoded and premultiplied with alpha in linear light, where it is averaged over
  /// `samples` and over squares of `supersampling` pixels. The viewport is its place and starts at
  /// `corner_px`.
  void draw(const Texture& drawn, int samples, int supersampling, const glm::ivec2& corner_px);

 private:
  const GladGLContext* gl;
  LazyProgram one;
  LazyProgram many;
  VertexArray no_arrays;
};

}  // namespace taut::renderer
