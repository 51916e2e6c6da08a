#include "renderer/passes/resolve_pass.hpp"

#include <array>

#include "renderer/gl/bindings.hpp"

namespace taut::renderer {

namespace {

constexpr std::array<std::string_view, 1> multisampled{"MULTISAMPLED"};

}  // namespace

ResolvePass::ResolvePass(const GladGLContext& context, std::span<const ShaderFile> files)
    : gl_(&context),
      one_(context, files, "fullscreen.vert", "resolve.frag"),
      many_(context, files, "fullscreen.vert", "resolve.frag", multisampled),
      no_arrays_(context) {}

void ResolvePass::draw(const Texture& drawn, int samples, int supersampling, const glm::ivec2& corner_px) {
  bind_texture(*gl_, drawn_unit, samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, drawn);
  const Program& program = (samples > 1 ? many_ : one_).use();
  program.set("resolve", glm::ivec4{samples, supersampling, corner_px});
  gl_->Disable(GL_DEPTH_TEST);
  begin_blending_over(*gl_);
  gl_->BindVertexArray(no_arrays_.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  end_blending_over(*gl_);
  gl_->Enable(GL_DEPTH_TEST);
}

}  // namespace taut::renderer
