#include "renderer/gl/picture_target.hpp"

namespace taut::renderer {
namespace {

Image read_pixels(const GladGLContext& gl, GLuint framebuffer, const Image& size) {
  Image image = make_image(size.width_px, size.height_px, size.channels);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, image.width_px, image.height_px, image.channels == 4 ? GL_RGBA : GL_RGB, GL_UNSIGNED_BYTE,
                image.pixels.data());
  check_errors(gl, "reading the picture");
  // OpenGL's first row is the lowest.
  const std::ptrdiff_t row_bytes = static_cast<std::ptrdiff_t>(image.width_px) * image.channels;
  for (int y = 0; y < image.height_px / 2; ++y) {
    std::swap_ranges(image.at(0, y), image.at(0, y) + row_bytes, image.at(0, image.height_px - 1 - y));
  }
  return image;
}

std::array<float, 256> byte_to_linear_table() {
  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = srgb_to_linear(static_cast<float>(i) / 255.0F);
  return linear;
}

// Divides colours by alpha; only pixels at outlines have an alpha between 0 and 1.
void divide_by_alpha(Image& image) {
  const std::array<float, 256> linear = byte_to_linear_table();
  for (std::uint8_t* pixel = image.pixels.data(); pixel != image.pixels.data() + image.pixels.size(); pixel += 4) {
    if (pixel[3] == 0 || pixel[3] == 255) continue;
    for (int i = 0; i < 3; ++i) {
      const float colour = linear[pixel[i]] * 255.0F / static_cast<float>(pixel[3]);
      pixel[i] = static_cast<std::uint8_t>(std::lround(255.0F * linear_to_srgb(colour)));
    }
  }
}

}  // namespace

VisibilityBuffer::VisibilityBuffer(const GladGLContext& context)
    : gl_(&context), triangle_framebuffer_(context), marks_framebuffer_(context) {
  max_samples_ = 16;
  for (const GLenum limit : {GL_MAX_SAMPLES, GL_MAX_INTEGER_SAMPLES, GL_MAX_COLOR_TEXTURE_SAMPLES}) {
    GLint limit_samples = 1;
    gl_->GetIntegerv(limit, &limit_samples);
    max_samples_ = std::min(max_samples_, limit_samples);
  }
}

void VisibilityBuffer::begin(int width_px, int height_px, int wanted_samples) {
  // shaders/surface.frag assumes four samples.
  const int usable = wanted_samples > 1 && max_samples_ >= 4 ? 4 : 1;
  if (width_px != width_px_ || height_px != height_px_ || usable != samples_) allocate(width_px, height_px, usable);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, triangle_framebuffer_.name());
  gl_->Viewport(0, 0, width_px, height_px);
  gl_->DepthMask(GL_TRUE);
  constexpr std::array<GLuint, 4> nothing{};
  gl_->ClearBufferuiv(GL_COLOR, 0, nothing.data());
  gl_->Clear(GL_DEPTH_BUFFER_BIT);
}

void VisibilityBuffer::allocate_texture(const Texture& texture, GLenum format) const {
  bind_texture(*gl_, drawn_unit, target(), texture);
  if (samples_ > 1) {
    gl_->TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples_, format, width_px_, height_px_, GL_TRUE);
    return;
  }
  const bool whole_numbers = format == GL_R32UI;
  gl_->TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width_px_, height_px_, 0,
                  whole_numbers ? GL_RED_INTEGER : GL_RGBA, whole_numbers ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE,
                  nullptr);
  set_sampling(*gl_, GL_TEXTURE_2D, GL_NEAREST);
}

// Attaches a texture to the bound framebuffer, with the shared depth.
void VisibilityBuffer::attach(const Texture& texture, const char* name) const {
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target(), texture.name(), 0);
  gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_->name());
  check_errors(*gl_, name);
  check_framebuffer(*gl_, name);
}

void VisibilityBuffer::allocate(int width_px, int height_px, int samples) {
  width_px_ = width_px;
  height_px_ = height_px;
  samples_ = samples;
  marks_colour_.reset();
  triangle_ids_.emplace(*gl_);
  depth_.emplace(*gl_);
  allocate_texture(*triangle_ids_, GL_R32UI);
  gl_->BindRenderbuffer(GL_RENDERBUFFER, depth_->name());
  gl_->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, GL_DEPTH_COMPONENT24, width_px,
                                      height_px);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, triangle_framebuffer_.name());
  attach(*triangle_ids_, "visibility buffer");
  for (int i = 0; i < samples && samples > 1; ++i) {
    std::array<GLfloat, 2> place{};
    gl_->GetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(i), place.data());
    sample_places_x_[i] = place[0];
    sample_places_y_[i] = place[1];
  }
}

void VisibilityBuffer::begin_marks() {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, marks_framebuffer_.name());
  if (!marks_colour_) {
    marks_colour_.emplace(*gl_);
    allocate_texture(*marks_colour_, GL_SRGB8_ALPHA8);
    attach(*marks_colour_, "marks");
  }
  gl_->Viewport(0, 0, width_px_, height_px_);
  gl_->ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  gl_->Clear(GL_COLOR_BUFFER_BIT);
}

PictureTarget::PictureTarget(const GladGLContext& context, GLenum stored_as)
    : gl_(&context), format_(stored_as), finished_(context) {}

void PictureTarget::begin(int width_px, int height_px) {
  if (width_px != width_px_ || height_px != height_px_) allocate(width_px, height_px);
  bind();
}

void PictureTarget::bind() const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, finished_.name());
  gl_->Viewport(0, 0, width_px_, height_px_);
}

void PictureTarget::allocate(int width_px, int height_px) {
  width_px_ = height_px_ = 0;
  colour_.emplace(*gl_);
  bind_texture(*gl_, drawn_unit, GL_TEXTURE_2D, *colour_);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format_), width_px, height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  nullptr);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, finished_.name());
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_->name(), 0);
  check_errors(*gl_, "making the picture's buffers");
  check_framebuffer(*gl_, "finished picture");
  width_px_ = width_px;
  height_px_ = height_px;
}

void PictureTarget::clear() const {
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  gl_->Clear(GL_COLOR_BUFFER_BIT);
}

Image PictureTarget::read(bool has_alpha) const {
  Image image = read_pixels(*gl_, finished_.name(), {width_px_, height_px_, has_alpha ? 4 : 3, {}});
  if (has_alpha) divide_by_alpha(image);
  return image;
}

void PictureTarget::show(GLuint target, int width_px, int height_px, int left_px) const {
  const bool is_same_size = width_px == width_px_ && height_px == height_px_;
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, finished_.name());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
  gl_->BlitFramebuffer(0, 0, width_px_, height_px_, left_px, 0, left_px + width_px, height_px, GL_COLOR_BUFFER_BIT,
                       is_same_size ? GL_NEAREST : GL_LINEAR);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target);
}

void GrowingTarget::begin(const glm::ivec2& size_px) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  const glm::ivec2 roomy_px = glm::max(size_px, size_px_);
  if (roomy_px != size_px_) {
    size_px_ = roomy_px;
    bind();
    gl_->TexImage2D(GL_TEXTURE_2D, 0, format_, size_px_.x, size_px_.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    set_sampling(*gl_, GL_TEXTURE_2D, GL_LINEAR);
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
    check_framebuffer(*gl_, "coarser picture");
  }
  gl_->Viewport(0, 0, size_px.x, size_px.y);
}

ColourTarget::ColourTarget(Context& context) : context_(context) {
  context.make_current();
  picture_ = std::make_unique<PictureTarget>(context.gl(), GL_RGBA8);
}

ColourTarget::~ColourTarget() { delete_in_context(context_, picture_); }

unsigned ColourTarget::framebuffer(int width_px, int height_px) {
  picture_->begin(width_px, height_px);
  return picture_->framebuffer();
}

void ColourTarget::copy_part_to(unsigned framebuffer, int x_px, int y_px, int width_px, int height_px) const {
  const GladGLContext& gl = context_.gl();
  gl.Disable(GL_SCISSOR_TEST);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, picture_->framebuffer());
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  gl.BlitFramebuffer(x_px, y_px, x_px + width_px, y_px + height_px, x_px, y_px, x_px + width_px, y_px + height_px,
                     GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  check_errors(gl, "copying a picture");
}

Image read_framebuffer(Context& context, unsigned framebuffer, int width_px, int height_px) {
  return read_pixels(context.gl(), framebuffer, {width_px, height_px, 3, {}});
}

void clear_framebuffer(Context& context, unsigned framebuffer, int width_px, int height_px, float grey) {
  const GladGLContext& gl = context.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.Viewport(0, 0, width_px, height_px);
  gl.Disable(GL_SCISSOR_TEST);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.ClearColor(grey, grey, grey, 1.0F);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

void finish_drawing(Context& context) { context.gl().Finish(); }

}  // namespace taut::renderer
