#include "renderer/shadow_pass.hpp"

#include <array>

#include "renderer/frame_block.hpp"

namespace taut::renderer {

namespace {

void set_up(const GladGLContext& gl, const Sampler& sampler, GLint filter) {
  constexpr std::array farthest{1.0F, 1.0F, 1.0F, 1.0F};
  gl.SamplerParameteri(sampler.name(), GL_TEXTURE_MIN_FILTER, filter);
  gl.SamplerParameteri(sampler.name(), GL_TEXTURE_MAG_FILTER, filter);
  gl.SamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl.SamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  gl.SamplerParameterfv(sampler.name(), GL_TEXTURE_BORDER_COLOR, farthest.data());
}

}  // namespace

DepthSamplers::DepthSamplers(const GladGLContext& gl) : compare(gl), plain(gl) {
  set_up(gl, compare, GL_LINEAR);
  gl.SamplerParameteri(compare.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.SamplerParameteri(compare.name(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  set_up(gl, plain, GL_NEAREST);
}

ShadowPass::ShadowPass(const GladGLContext& context, std::span<const ShaderFile> files)
    : gl(&context), depth(context, files, "depth.vert", "depth.frag"), map(context), framebuffer(context) {}

void ShadowPass::draw(Casters casters, const glm::mat4& world_to_shadow, int side_px) {
  if (allocated_px != side_px) {
    allocate_depth(*gl, map, side_px, side_px);
    attach_depth(*gl, framebuffer, map);
    allocated_px = side_px;
  }
  gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl->Viewport(0, 0, side_px, side_px);
  gl->Clear(GL_DEPTH_BUFFER_BIT);
  depth.use();
  depth.set("world_to_map", unit_cube_to_clip() * world_to_shadow);
  for (const SurfaceBuffers* caster : casters) caster->draw();
}

}  // namespace taut::renderer
