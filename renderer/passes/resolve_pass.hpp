#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "renderer/gl/gl_objects.hpp"
#include "renderer/gl/lazy_program.hpp"

namespace taut::renderer {

/// Averages samples and supersampled pixels and blends the result over the bound framebuffer.
class ResolvePass {
 public:
  /// The context must be current and outlive this object. `files`: all shaders.
  ResolvePass(const GladGLContext& context, std::span<const ShaderFile> files);

  /// Averages `drawn` in linear light over its `samples` and over squares of `supersampling` pixels. `drawn`
  /// is sRGB-encoded and was premultiplied in linear light. The viewport must be its place in the
  /// framebuffer; `corner_px` is the viewport's lower left corner.
  void draw(const Texture& drawn, int samples, int supersampling, const glm::ivec2& corner_px);

 private:
  const GladGLContext* gl_;
  LazyProgram one_;
  LazyProgram many_;
  VertexArray no_arrays_;
};

}  // namespace taut::renderer
