#include "renderer/passes/sampling_pass.hpp"

namespace taut::renderer {

SamplingPass::SamplingPass(const GladGLContext& context)
    : gl_(&context),
      surfaces_(context, GL_RGBA32F),
      behind_(context, GL_RGBA32F),
      marks_(context, GL_RGBA32F),
      backdrop_(context, "fullscreen.vert", "backdrop_sampled.frag"),
      film_(context, "fullscreen.vert", "film.frag"),
      no_arrays_(context) {}

void SamplingPass::begin(int width_px, int height_px) {
  const auto clear = [](PictureTarget& sums, int width, int height) {
    sums.begin(width, height);
    sums.clear();
  };
  clear(surfaces_, width_px, height_px);
  clear(marks_, width_px, height_px);
  clear(behind_, (width_px + 1) / 2, (height_px + 1) / 2);
  bind_texture(*gl_, behind_unit, GL_TEXTURE_2D, behind_.texture());
  set_sampling(*gl_, GL_TEXTURE_2D, GL_LINEAR);
}

void SamplingPass::set_behind(const glm::vec4& colour, int passes) const {
  behind_.bind();
  const glm::vec4 sum = static_cast<float>(passes) * colour;
  gl_->ClearBufferfv(GL_COLOR, 0, &sum.x);
}

void SamplingPass::add_backdrop() {
  behind_.bind();
  gl_->Disable(GL_DEPTH_TEST);
  begin_adding(*gl_);
  gl_->BindVertexArray(no_arrays_.name());
  backdrop_.use();
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  end_blending_over(*gl_);
  gl_->Enable(GL_DEPTH_TEST);
}

void SamplingPass::develop(GLuint framebuffer, const PixelRect& place, int passes, bool data_colours) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_->Viewport(place.x_px, place.y_px, place.width_px, place.height_px);
  bind_texture(*gl_, drawn_unit, GL_TEXTURE_2D, surfaces_.texture());
  bind_texture(*gl_, behind_unit, GL_TEXTURE_2D, behind_.texture());
  bind_texture(*gl_, marks_unit, GL_TEXTURE_2D, marks_.texture());
  const Program& program = film_.use();
  program.set("corner", glm::ivec4{place.x_px, place.y_px, 0, 0});
  program.set("film", glm::vec4{1.0F / static_cast<float>(passes), data_colours ? 1.0F : 0.0F, 0.0F, 0.0F});
  gl_->Disable(GL_DEPTH_TEST);
  gl_->BindVertexArray(no_arrays_.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl_->Enable(GL_DEPTH_TEST);
}

}  // namespace taut::renderer
