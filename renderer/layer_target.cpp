#include "renderer/layer_target.hpp"

#include <algorithm>
#include <array>

#include "renderer/bindings.hpp"

namespace taut::renderer {

namespace {

constexpr std::array<std::string_view, 1> multisampled{"MULTISAMPLED"};

}  // namespace

LayerTarget::LayerTarget(const GladGLContext& context, std::span<const ShaderFile> files)
    : gl(&context),
      resolve_one(context, files, "fullscreen.vert", "resolve.frag"),
      resolve_many(context, files, "fullscreen.vert", "resolve.frag", multisampled),
      no_arrays(context),
      behind(context),
      drawn(context) {
  gl->GetIntegerv(GL_MAX_SAMPLES, &most_samples);
  gl->BindTexture(GL_TEXTURE_2D, behind.name());
  gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl->BindTexture(GL_TEXTURE_2D, 0);
}

int LayerTarget::usable_samples(int wanted) const {
  return std::clamp(wanted, 1, std::max(most_samples, 1));
}

void LayerTarget::begin(int width_px, int height_px, int samples) {
  const int usable = usable_samples(samples);
  if (width_px != drawn_width_px || height_px != drawn_height_px || usable != drawn_samples) {
    allocate(width_px, height_px, usable);
  }
  gl->BindFramebuffer(GL_FRAMEBUFFER, drawn.name());
  gl->Viewport(0, 0, width_px, height_px);
  gl->DepthMask(GL_TRUE);
  gl->ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void LayerTarget::allocate(int width_px, int height_px, int samples) {
  drawn_width_px = drawn_height_px = drawn_samples = 0;
  colour.emplace(*gl);
  depth.emplace(*gl);
  const GLenum target = samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  gl->ActiveTexture(GL_TEXTURE0 + drawn_unit);
  gl->BindTexture(target, colour->name());
  if (samples > 1) {
    gl->TexImage2DMultisample(target, samples, GL_SRGB8_ALPHA8, width_px, height_px, GL_TRUE);
  } else {
    gl->TexImage2D(target, 0, GL_SRGB8_ALPHA8, width_px, height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl->TexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
  }
  gl->BindRenderbuffer(GL_RENDERBUFFER, depth->name());
  gl->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, GL_DEPTH_COMPONENT24,
                                     width_px, height_px);
  gl->BindFramebuffer(GL_FRAMEBUFFER, drawn.name());
  gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, colour->name(), 0);
  gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth->name());
  check_errors(*gl, "making the layer's buffers");
  check_framebuffer(*gl, "layer");
  drawn_width_px = width_px;
  drawn_height_px = height_px;
  drawn_samples = samples;
}

void LayerTarget::copy_behind(GLuint picture, const Tile& tile, int bottom_px) {
  gl->BindFramebuffer(GL_READ_FRAMEBUFFER, picture);
  bind_texture(*gl, behind_unit, GL_TEXTURE_2D, behind);
  gl->CopyTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, tile.x_px, bottom_px, tile.width_px, tile.height_px,
                     0);
}

void LayerTarget::resolve(GLuint picture, const Tile& tile, int picture_height_px, int supersampling) {
  const int bottom_px = picture_height_px - tile.y_px - tile.height_px;
  const bool many = drawn_samples > 1;
  copy_behind(picture, tile, bottom_px);
  gl->BindFramebuffer(GL_FRAMEBUFFER, picture);
  gl->Viewport(tile.x_px, bottom_px, tile.width_px, tile.height_px);
  bind_texture(*gl, drawn_unit, many ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, *colour);
  const Program& program = (many ? resolve_many : resolve_one).use();
  program.set("resolve", glm::ivec4{drawn_samples, supersampling, tile.x_px, bottom_px});
  gl->Disable(GL_DEPTH_TEST);
  gl->BindVertexArray(no_arrays.name());
  gl->DrawArrays(GL_TRIANGLES, 0, 3);
  gl->Enable(GL_DEPTH_TEST);
}

}  // namespace taut::renderer
