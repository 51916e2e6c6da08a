#include "renderer/passes/overlay_pass.hpp"

#include "renderer/gl/gl_objects.hpp"

namespace taut::renderer {

struct OverlayPass::OverlayResources {
  Context& context;
  const GladGLContext& gl;
  Program program;
  VertexArray arrays;
  Buffer vertices;
  Buffer indices;
  Texture sheet;

  explicit OverlayResources(Context& made)
      : context(made),
        gl(made.gl()),
        program(gl, embedded_shaders(), "overlay.vert", "overlay.frag"),
        arrays(gl),
        vertices(gl),
        indices(gl),
        sheet(gl) {
    constexpr GLsizei stride = sizeof(OverlayVertex);
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    gl.BindVertexArray(arrays.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices.name());
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(OverlayVertex, position_px)));
    gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(OverlayVertex, sheet_place)));
    gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, offset(offsetof(OverlayVertex, colour_rgba8)));
    for (GLuint location = 0; location < 3; ++location) gl.EnableVertexAttribArray(location);
    gl.BindVertexArray(0);
  }

  void set_state() const {
    for (const GLenum off : {GL_CULL_FACE, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_FRAMEBUFFER_SRGB}) gl.Disable(off);
    gl.Enable(GL_BLEND);
    gl.Enable(GL_SCISSOR_TEST);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  }

  void draw_part(const OverlayPart& part, int width_px, int height_px) const {
    const glm::ivec2 lower{std::max(part.clip_lower_px.x, 0), std::max(part.clip_lower_px.y, 0)};
    const glm::ivec2 upper{std::min(part.clip_upper_px.x, width_px), std::min(part.clip_upper_px.y, height_px)};
    if (upper.x <= lower.x || upper.y <= lower.y) return;
    gl.Scissor(lower.x, height_px - upper.y, upper.x - lower.x, upper.y - lower.y);
    gl.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(part.index_count), GL_UNSIGNED_SHORT,
                              reinterpret_cast<const void*>(part.first_index * sizeof(std::uint16_t)),
                              static_cast<GLint>(part.first_vertex));
  }
};

OverlayPass::OverlayPass(Context& context) {
  context.make_current();
  parts_ = std::make_unique<OverlayResources>(context);
}

OverlayPass::~OverlayPass() { delete_in_context(parts_->context, parts_); }

void OverlayPass::set_sheet(int width_px, int height_px, std::span<const std::uint8_t> rgba) {
  const GladGLContext& gl = parts_->gl;
  bind_texture(gl, 0, GL_TEXTURE_2D, parts_->sheet);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_px, height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  set_sampling(gl, GL_TEXTURE_2D, GL_LINEAR);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  check_errors(gl, "storing the letters");
}

void OverlayPass::draw(unsigned framebuffer, int width_px, int height_px, const OverlayView& overlay) {
  const GladGLContext& gl = parts_->gl;
  parts_->set_state();
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.Viewport(0, 0, width_px, height_px);
  parts_->program.use();
  parts_->program.set("pixels_to_clip", glm::vec4{2.0F / static_cast<float>(width_px),
                                                  -2.0F / static_cast<float>(height_px), -1.0F, 1.0F});
  parts_->program.set("sheet", 0);
  gl.BindSampler(0, 0);
  bind_texture(gl, 0, GL_TEXTURE_2D, parts_->sheet);
  gl.BindVertexArray(parts_->arrays.name());
  upload(gl, GL_ARRAY_BUFFER, parts_->vertices, overlay.vertices);
  upload(gl, GL_ELEMENT_ARRAY_BUFFER, parts_->indices, overlay.indices);
  for (const OverlayPart& part : overlay.parts) parts_->draw_part(part, width_px, height_px);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_BLEND);
  gl.BindVertexArray(0);
  gl.UseProgram(0);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  check_errors(gl, "drawing the user interface");
}

}  // namespace taut::renderer
