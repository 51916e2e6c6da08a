#include "renderer/gl/gl_objects.hpp"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace taut::renderer {
namespace {

std::string hexadecimal(GLenum value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%04X", value);
  return text;
}

// Names of samplers, by texture unit.
constexpr std::array<const char*, unit_count> samplers = {
    "key_map",     "key_depth",     "ground_light",  "scalar_maps",  "drawn",  "visibility_buffer",
    "vertex_data", "triangle_data", "material_data", "floor_shadow", "halved", "base_colour_maps",
    "corner_data", "trim_data",     "sky_maps",      "behind",       "marks",  "vertex_light"};

std::string_view shader_text(std::span<const ShaderFile> files, std::string_view name) {
  for (const ShaderFile& file : files) {
    if (file.name == name) return file.text;
  }
  throw ShaderError("there is no shader file '" + std::string(name) + "'");
}

// Inserts defines after the first line, which has to be the version.
std::string with_defines(std::string_view text, std::string_view defines) {
  const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
  return std::string(text.substr(0, end)).append(defines).append("#line 2\n").append(text.substr(end));
}

// Replaces the source number 0 with which drivers begin every line: "0:12(5): error" (Mesa), "0(12) : error" (NVIDIA).
std::string with_file_name(const std::string& log, std::string_view name) {
  std::istringstream lines(log);
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    const bool is_numbered = line.starts_with("0:") || line.starts_with("0(");
    out += "\n  " + (is_numbered ? std::string(name) + line.substr(1) : line);
  }
  return out;
}

template <typename GetValue, typename GetLog> std::string info_log(GLuint object, GetValue get_value, GetLog get_log) {
  GLint length = 0;
  get_value(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  get_log(object, length, &length, log.data());
  log.resize(static_cast<std::size_t>(std::max(length, 0)));
  return log;
}

struct Stage {
  const GladGLContext& gl;
  GLuint shader;

  Stage(const GladGLContext& context, GLenum kind, std::span<const ShaderFile> files, std::string_view name,
        std::string_view defines)
      : gl(context), shader(gl.CreateShader(kind)) {
    try {
      compile(files, name, defines);
    } catch (...) {
      gl.DeleteShader(shader);
      throw;
    }
  }
  ~Stage() { gl.DeleteShader(shader); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

 private:
  void compile(std::span<const ShaderFile> files, std::string_view name, std::string_view defines) const {
    const std::string source = with_defines(shader_text(files, name), defines);
    const char* text = source.c_str();
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    GLint compiled = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return;
    const std::string log = info_log(shader, gl.GetShaderiv, gl.GetShaderInfoLog);
    throw ShaderError("the shader '" + std::string(name) + "' does not compile:" + with_file_name(log, name));
  }
};

// Tangent of half the visual angle of the key light: a large softbox. Higher values give softer shadows and need more
// taps against noise.
constexpr float key_softness = 0.10F;
// Radius of the lit floor in units of the scene's radius. With lower values the floor's end shows.
constexpr float floor_radius = 9.0F;
// Radius of the widest blur of a shadow, as a fraction of the map's side. Higher values are softer far from casters,
// and need more taps against noise.
constexpr float max_blur_fraction = 0.1F;
// Taps on the floor per tap on a surface: the floor's shadow has a fourth of the pixels.
constexpr float floor_tap_factor = 1.75F;
// Texels of the shadow map per drawn pixel of the picture's shorter side. Higher values are sharper than the picture
// can show.
constexpr float texels_for_pixel = 1.4F;
// Smallest shadow map. Smaller ones show dots in narrow penumbrae, however small the picture.
constexpr int min_shadow_map_px = 1024;
// Reach of the floor's light texture beyond the scene's radius, as a fraction of the scene's height above the floor:
// high objects darken a wider and fainter patch. Lower values cut that patch off, higher ones make it coarser.
constexpr float light_reach = 1.5F;
// Extent of the backdrop's gradient above the middle of the picture, as a fraction of the field of view.
constexpr float gradient_extent = 0.65F;

glm::vec4 light(const glm::vec3& towards, float strength) {
  const float length = glm::length(towards);
  const glm::vec3 unit = length > 0.0F ? towards / length : glm::vec3{0.0F, 1.0F, 0.0F};
  return {unit, strength};
}

float bounding_radius(const Box& box) { return std::max(0.5F * glm::length(box.upper - box.lower), 1e-3F); }

glm::vec3 box_middle(const Box& box) { return 0.5F * (box.lower + box.upper); }

void set_shadow(FrameBlock& block, const PictureSettings& settings, const std::optional<Box>& casters,
                float max_bulge_m) {
  block.world_to_shadow = glm::mat4{1.0F};
  block.shadow = glm::vec4{1.0F, 1.0F, 1.0F, 0.0F};
  if (!casters || !settings.shadows) return;
  const glm::vec3 towards{block.towards_key};
  block.world_to_shadow = world_to_unit_cube(*casters, towards);
  const float side_m = 2.0F * bounding_radius(*casters);
  const auto texels = static_cast<float>(shadow_map_side(settings));
  block.shadow = {side_m / texels, 1.0F / texels, side_m, key_softness};
  const auto taps = static_cast<float>(settings.shadow_taps);
  block.shadow_blur = {max_blur_fraction * texels, taps, floor_tap_factor * taps, max_bulge_m};
}

void set_ground(FrameBlock& block, const FrameView& frame, const std::optional<Box>& casters) {
  const Box box = casters.value_or(Box{frame.camera.target - 1.0F, frame.camera.target + 1.0F});
  const glm::vec3 middle = box_middle(box);
  const float height = frame.ground_height_m.value_or(0.0F);
  const float radius = bounding_radius(box);
  block.ground = {middle.x, height, middle.z, floor_radius * radius};
  const float reach = radius + light_reach * std::max(middle.y - height, 0.0F);
  block.ground_light_area = {middle.x - reach, middle.z - reach, 0.5F / reach, 0.5F / reach};
}

glm::mat4 clip_to_tile(const PictureSettings& settings, const Tile& tile) {
  const auto width = static_cast<float>(settings.width_px);
  const auto height = static_cast<float>(settings.height_px);
  const auto tile_width = static_cast<float>(tile.width_px);
  const auto tile_height = static_cast<float>(tile.height_px);
  const glm::vec2 scale{width / tile_width, height / tile_height};
  const glm::vec2 centre{(2.0F * static_cast<float>(tile.x_px) + tile_width) / width - 1.0F,
                         1.0F - (2.0F * static_cast<float>(tile.y_px) + tile_height) / height};
  const glm::mat4 scaled = glm::scale(glm::mat4{1.0F}, glm::vec3{scale, 1.0F});
  return glm::translate(scaled, glm::vec3{-centre, 0.0F});
}

// Sets view rays through a plane at distance 1 in front of the eye.
void set_rays(FrameBlock& block, const Camera& camera, const PictureSettings& settings, const Tile& tile) {
  const glm::mat3 axes = glm::transpose(glm::mat3{camera.view()});
  const float half_height = std::tan(0.5F * camera.vertical_fov_rad);
  const float pixel = 2.0F * half_height / static_cast<float>(settings.height_px);
  const auto left = static_cast<float>(tile.x_px) - 0.5F * static_cast<float>(settings.width_px);
  const auto bottom = 0.5F * static_cast<float>(settings.height_px) - static_cast<float>(tile.y_px + tile.height_px);
  const auto scale = static_cast<float>(settings.supersampling);
  const float drawn_pixel = pixel / scale;
  block.ray_corner =
      glm::vec4{axes * glm::vec3{pixel * left, pixel * bottom, -1.0F}, scale * static_cast<float>(tile.x_px)};
  block.ray_across = glm::vec4{drawn_pixel * axes[0], scale * static_cast<float>(settings.width_px)};
  block.ray_up =
      glm::vec4{drawn_pixel * axes[1], scale * static_cast<float>(settings.height_px - tile.y_px - tile.height_px)};
}

}  // namespace

void set_attribute(const GladGLContext& gl, GLuint location, const Buffer& buffer, int components, int stride_floats,
                   int offset_floats, GLuint divisor) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.name());
  gl.EnableVertexAttribArray(location);
  const auto offset = static_cast<std::uintptr_t>(offset_floats) * sizeof(float);
  gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, stride_floats * static_cast<GLsizei>(sizeof(float)),
                         reinterpret_cast<const void*>(offset));
  gl.VertexAttribDivisor(location, divisor);
}

void bind_texture(const GladGLContext& gl, unsigned unit, GLenum target, const Texture& texture) {
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.BindTexture(target, texture.name());
}

void set_sampling(const GladGLContext& gl, GLenum target, GLint filter, GLint wrap) {
  gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_S, wrap);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_T, wrap);
}

void begin_blending_over(const GladGLContext& gl) {
  gl.Enable(GL_FRAMEBUFFER_SRGB);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void begin_adding(const GladGLContext& gl) {
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
}

void end_blending_over(const GladGLContext& gl) {
  gl.Disable(GL_BLEND);
  gl.Disable(GL_FRAMEBUFFER_SRGB);
}

void check_errors(const GladGLContext& gl, const char* stage) {
  const GLenum error = gl.GetError();
  if (error == GL_NO_ERROR) return;
  while (gl.GetError() != GL_NO_ERROR) {
  }
  throw ContextError(std::string("OpenGL error ") + hexadecimal(error) + " in " + stage);
}

void check_framebuffer(const GladGLContext& gl, const char* stage) {
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw ContextError(std::string("OpenGL cannot draw to the ") + stage + ", status " + hexadecimal(status));
  }
}

Program::Program(const GladGLContext& context, std::span<const ShaderFile> files, std::string_view vertex_file,
                 std::string_view fragment_file, std::span<const std::string_view> defines)
    : gl_(&context) {
  std::string define_lines;
  for (const std::string_view define : defines) define_lines += "#define " + std::string(define) + "\n";
  const Stage vertex(context, GL_VERTEX_SHADER, files, vertex_file, define_lines);
  const Stage fragment(context, GL_FRAGMENT_SHADER, files, fragment_file, define_lines);
  program_ = gl_->CreateProgram();
  gl_->AttachShader(program_, vertex.shader);
  gl_->AttachShader(program_, fragment.shader);
  gl_->LinkProgram(program_);
  GLint linked = GL_FALSE;
  gl_->GetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  const std::string log = info_log(program_, gl_->GetProgramiv, gl_->GetProgramInfoLog);
  gl_->DeleteProgram(program_);
  throw ShaderError("the shaders '" + std::string(vertex_file) + "' and '" + std::string(fragment_file) +
                    "' do not link:\n  " + log);
}

Program::~Program() {
  if (program_ != 0) gl_->DeleteProgram(program_);
}

Program::Program(Program&& other) noexcept : gl_(other.gl_), program_(std::exchange(other.program_, 0)) {}

void Program::set(const char* uniform, int value) const {
  gl_->Uniform1i(gl_->GetUniformLocation(program_, uniform), value);
}

void Program::set(const char* uniform, const glm::vec4& value) const {
  gl_->Uniform4fv(gl_->GetUniformLocation(program_, uniform), 1, glm::value_ptr(value));
}

void Program::set(const char* uniform, const glm::ivec4& value) const {
  gl_->Uniform4iv(gl_->GetUniformLocation(program_, uniform), 1, glm::value_ptr(value));
}

void Program::bind_block(const char* block, unsigned binding) const {
  const GLuint index = gl_->GetUniformBlockIndex(program_, block);
  if (index != GL_INVALID_INDEX) gl_->UniformBlockBinding(program_, index, binding);
}

void bind_shared_inputs(const Program& program) {
  program.bind_block("Frame", frame_block_binding);
  program.use();
  for (unsigned unit = 0; unit < unit_count; ++unit) program.set(samplers[unit], static_cast<int>(unit));
}

const Program& LazyProgram::use() {
  if (!program_) {
    program_.emplace(*gl_, embedded_shaders(), vertex_, fragment_, defines_);
    bind_shared_inputs(*program_);
  }
  program_->use();
  return *program_;
}

int shadow_map_side(const PictureSettings& settings) {
  const int drawn_px = settings.supersampling * std::min(settings.width_px, settings.height_px);
  int side_px = min_shadow_map_px;
  while (static_cast<float>(side_px) < texels_for_pixel * static_cast<float>(drawn_px)) side_px *= 2;
  return std::min(side_px, settings.shadow_map_px);
}

FrameBlock make_frame_block(const FrameView& frame, const PictureSettings& settings,
                            const std::optional<Box>& casters) {
  FrameBlock block{};
  const Lighting& lighting = frame.lighting;
  block.eye = glm::vec4{frame.camera.eye, 1.0F};
  block.towards_key = light(lighting.towards_key, lighting.key);
  block.towards_fill = light(lighting.towards_fill, lighting.fill);
  block.towards_rim = light(lighting.towards_rim, lighting.rim);
  const Backdrop& backdrop = frame.backdrop;
  const Colour white{1.0F};
  block.upper_colour = glm::vec4{linear_light(backdrop.transparent ? white : backdrop.upper_colour), lighting.ambient};
  block.lower_colour =
      glm::vec4{linear_light(backdrop.transparent ? white : backdrop.lower_colour), backdrop.plain ? 1.0F : 0.0F};
  float max_bulge_m = 0.0F;
  for (const SurfaceView& surface : frame.surfaces) {
    if (surface.refinement && settings.passes == 1)
      max_bulge_m = std::max(max_bulge_m, surface.refinement->max_bulge_m);
  }
  set_shadow(block, settings, casters, max_bulge_m);
  set_ground(block, frame, casters);
  // The backdrop's gradient starts at the middle of the picture for any camera direction.
  const glm::vec3 forward = glm::normalize(frame.camera.target - frame.camera.eye);
  const float pitch = std::asin(std::clamp(forward.y, -1.0F, 1.0F));
  block.backdrop_horizon = {std::sin(pitch),
                            std::sin(std::min(pitch + gradient_extent * frame.camera.vertical_fov_rad, 1.57F)),
                            backdrop.transparent ? 1.0F : 0.0F, 0.0F};
  return block;
}

void set_shadow_bounds(FrameBlock& block, std::span<const SurfaceView> casters) {
  glm::vec2 lower{1.0F};
  glm::vec2 upper{0.0F};
  for (const SurfaceView& caster : casters) {
    for (const glm::vec3& position : caster.positions) {
      const glm::vec2 place{block.world_to_shadow * glm::vec4{position, 1.0F}};
      lower = glm::min(lower, place);
      upper = glm::max(upper, place);
    }
  }
  block.shadow_bounds = {lower, upper};
}

void set_tile(FrameBlock& block, const Camera& camera, const PictureSettings& settings, const Tile& tile,
              const glm::vec2& offset_px) {
  block.world_to_clip = clip_to_tile(settings, tile) * camera.projection(settings.aspect()) * camera.view();
  const auto scale = static_cast<float>(settings.supersampling);
  block.viewport = {static_cast<float>(tile.width_px) * scale, static_cast<float>(tile.height_px) * scale, scale,
                    static_cast<float>(settings.height_px) * scale};
  set_rays(block, camera, settings, tile);
  if (offset_px == glm::vec2{0.0F}) return;
  const glm::vec2 moved = 2.0F * offset_px / glm::vec2{block.viewport};
  block.world_to_clip = glm::translate(glm::mat4{1.0F}, {moved, 0.0F}) * block.world_to_clip;
  block.ray_corner -= glm::vec4{glm::vec3{offset_px.x * block.ray_across + offset_px.y * block.ray_up}, 0.0F};
}

glm::mat4 world_to_unit_cube(const Box& box, const glm::vec3& towards) {
  const float radius = bounding_radius(box) * 1.001F;
  const glm::vec3 middle = box_middle(box);
  const glm::vec3 up = std::abs(towards.y) < 0.99F ? glm::vec3{0.0F, 1.0F, 0.0F} : glm::vec3{0.0F, 0.0F, 1.0F};
  const glm::mat4 view = glm::lookAt(middle + towards * radius, middle, up);
  const glm::mat4 clip = glm::ortho(-radius, radius, -radius, radius, 0.0F, 2.0F * radius);
  const glm::mat4 halved = glm::translate(glm::mat4{1.0F}, glm::vec3{0.5F});
  return glm::scale(halved, glm::vec3{0.5F}) * clip * view;
}

}  // namespace taut::renderer
