#include "renderer/passes/resolve_pass.hpp"

#include <array>

#include "renderer/gl/bindings.hpp"

namespace taut::renderer {

namespace {

constexpr std::array<std::string_view, 1> multisampled{"MULTISAMPLED"};

}  // namespace

ResolvePass::ResolvePass(const GladGLContext& context, std::span<const ShaderFile> files)
    : gl(&context),
      one(context, files, "fullscreen.vert", "resolve.frag"),
      many(context, files, "fullscreen.vert", "resolve.frag", multisampled),
      no_arrays(context) {}

void ResolvePass::draw(const Texture& drawn, int samples, int supersampling, const glm::ivec2& corner_px) {
  bind_texture(*gl, drawn_unit, samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, drawn);
  const Program& program = (samples > 1 ? many : one).use();
  program.set("resolve", glm::ivec4{samples, supersampling, corner_px});
  gl->Disable(GL_DEPTH_TEST);
  begin_laying_over(*gl);
  gl->BindVertexArray(no_arrays.name());
  gl->DrawArrays(GL_TRIANGLES, 0, 3);
  end_laying_over(*gl);
  gl->Enable(GL_DEPTH_TEST);
}

}  // namespace taut::renderer
