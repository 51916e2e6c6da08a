#include "renderer/picture_target.hpp"

#include <algorithm>
#include <array>

#include "renderer/bindings.hpp"

namespace taut::renderer {

namespace {

constexpr std::array<std::string_view, 1> multisampled{"MULTISAMPLED"};

}  // namespace

PictureTarget::PictureTarget(const GladGLContext& context, std::span<const ShaderFile> files)
    : gl(&context),
      resolve_one(context, files, "fullscreen.vert", "resolve.frag"),
      resolve_many(context, files, "fullscreen.vert", "resolve.frag", multisampled),
      no_arrays(context),
      drawn(context),
      finished(context) {
  gl->GetIntegerv(GL_MAX_SAMPLES, &most_samples);
  bind_shared_inputs(resolve_one);
  bind_shared_inputs(resolve_many);
}

void PictureTarget::begin(int width_px, int height_px, int samples) {
  const int usable = std::clamp(samples, 1, std::max(most_samples, 1));
  if (width_px != drawn_width_px || height_px != drawn_height_px || usable != drawn_samples) {
    allocate(width_px, height_px, usable);
  }
  gl->BindFramebuffer(GL_FRAMEBUFFER, drawn.name());
  gl->Viewport(0, 0, width_px, height_px);
  gl->DepthMask(GL_TRUE);
  gl->Clear(GL_DEPTH_BUFFER_BIT);
}

void PictureTarget::allocate(int width_px, int height_px, int samples) {
  drawn_width_px = drawn_height_px = drawn_samples = 0;
  colour.emplace(*gl);
  depth.emplace(*gl);
  const GLenum target = samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  gl->ActiveTexture(GL_TEXTURE0 + drawn_unit);
  gl->BindTexture(target, colour->name());
  // Eight bits are enough because sRGB encoding spends them where the eye does.
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
  check_errors(*gl, "making the picture's buffers");
  check_framebuffer(*gl, "picture");
  drawn_width_px = width_px;
  drawn_height_px = height_px;
  drawn_samples = samples;
}

void PictureTarget::resolve(GLuint framebuffer, const Tile& tile, int picture_height, int supersampling,
                            bool top_first) {
  const int bottom_px = top_first ? tile.y_px : picture_height - tile.y_px - tile.height_px;
  const bool many = drawn_samples > 1;
  gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl->Viewport(tile.x_px, bottom_px, tile.width_px, tile.height_px);
  bind_texture(*gl, drawn_unit, many ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, *colour);
  const Program& program = many ? resolve_many : resolve_one;
  program.use();
  program.set("resolve", glm::ivec4{drawn_samples, supersampling, tile.height_px, top_first ? 1 : 0});
  program.set("corner", glm::ivec4{tile.x_px, bottom_px, 0, 0});
  gl->BindVertexArray(no_arrays.name());
  gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

GLuint PictureTarget::picture_framebuffer(int width_px, int height_px) {
  if (width_px == picture_width_px && height_px == picture_height_px) return finished.name();
  picture_width_px = picture_height_px = 0;
  picture.emplace(*gl);
  gl->BindTexture(GL_TEXTURE_2D, picture->name());
  // Bytes as they are: the resolve shader has encoded them.
  gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_px, height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl->BindFramebuffer(GL_FRAMEBUFFER, finished.name());
  gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture->name(), 0);
  check_framebuffer(*gl, "finished picture");
  picture_width_px = width_px;
  picture_height_px = height_px;
  return finished.name();
}

Image PictureTarget::read(int width_px, int height_px) const {
  Image image = make_image(width_px, height_px);
  gl->BindFramebuffer(GL_FRAMEBUFFER, finished.name());
  gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl->ReadPixels(0, 0, width_px, height_px, GL_RGB, GL_UNSIGNED_BYTE, image.pixels.data());
  return image;
}

}  // namespace taut::renderer
