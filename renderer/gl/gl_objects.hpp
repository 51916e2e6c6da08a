#pragma once

#include <glad/gl.h>

#include "renderer/context/context.hpp"
#include "renderer/frame_view.hpp"

namespace taut::renderer {

/// Owner of an OpenGL object made by Create and deleted by Delete. The context must be current in the constructor and
/// the destructor.
template <auto Create, auto Delete> class GlObject {
 public:
  explicit GlObject(const GladGLContext& context) : gl_(&context) { (gl_->*Create)(1, &object_); }
  ~GlObject() {
    if (object_ != 0) (gl_->*Delete)(1, &object_);
  }
  GlObject(GlObject&& other) noexcept : gl_(other.gl_), object_(std::exchange(other.object_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(object_, other.object_);
    return *this;
  }

  /// Returns the object's OpenGL name.
  GLuint name() const { return object_; }

 private:
  const GladGLContext* gl_;
  GLuint object_ = 0;
};

using Buffer = GlObject<&GladGLContext::GenBuffers, &GladGLContext::DeleteBuffers>;
using VertexArray = GlObject<&GladGLContext::GenVertexArrays, &GladGLContext::DeleteVertexArrays>;
using Texture = GlObject<&GladGLContext::GenTextures, &GladGLContext::DeleteTextures>;
using Framebuffer = GlObject<&GladGLContext::GenFramebuffers, &GladGLContext::DeleteFramebuffers>;
using Renderbuffer = GlObject<&GladGLContext::GenRenderbuffers, &GladGLContext::DeleteRenderbuffers>;
using Sampler = GlObject<&GladGLContext::GenSamplers, &GladGLContext::DeleteSamplers>;

/// Replaces a buffer's contents. The driver provides new memory rather than wait for the last picture.
template <typename Value>
void upload(const GladGLContext& gl, GLenum target, const Buffer& buffer, std::span<const Value> values) {
  gl.BindBuffer(target, buffer.name());
  gl.BufferData(target, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), GL_STREAM_DRAW);
}

/// Sets a float attribute of the bound vertex array. Stride and offset are in floats. divisor 1: one value
/// per instance instead of per vertex.
void set_attribute(const GladGLContext& gl, GLuint location, const Buffer& buffer, int components, int stride_floats,
                   int offset_floats, GLuint divisor = 0);

/// Binds a texture to a texture unit, which becomes the active one.
void bind_texture(const GladGLContext& gl, unsigned unit, GLenum target, const Texture& texture);

/// Sets the filter and the wrapping of the bound texture, and restricts it to its largest level.
void set_sampling(const GladGLContext& gl, GLenum target, GLint filter, GLint wrap = GL_CLAMP_TO_EDGE);

/// Makes the context of some objects current for their deletion. If that fails, their OpenGL names leak until the
/// process ends, as deleting them is undefined.
template <class Parts> void delete_in_context(Context& context, std::unique_ptr<Parts>& parts) {
  try {
    context.make_current();
  } catch (const ContextError&) {
    static_cast<void>(parts.release());
  }
}

/// Begin and end blending with the "over" operator (Porter and Duff 1984): fragments are premultiplied linear
/// light, the framebuffer is sRGB-encoded.
void begin_blending_over(const GladGLContext& gl);
void end_blending_over(const GladGLContext& gl);
/// Begins adding fragments to the framebuffer, until end_blending_over().
void begin_adding(const GladGLContext& gl);

/// Throw ContextError naming `stage` when OpenGL has recorded an error, or when the bound framebuffer is
/// incomplete.
void check_errors(const GladGLContext& gl, const char* stage);
void check_framebuffer(const GladGLContext& gl, const char* stage);

/// Thrown if a shader does not compile or link. The message has the file and the line of every error.
struct ShaderError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One shader of the shaders folder.
struct ShaderFile {
  std::string_view name;  ///< without folder, e.g. "surface.frag"
  std::string_view text;  ///< source with its includes
};

/// Returns all shaders as embedded in the build.
std::span<const ShaderFile> embedded_shaders();

/// Linked vertex and fragment shader.
class Program {
 public:
  /// Compiles two of `files`, by name. Each of `defines` is defined in both. Throws ShaderError.
  Program(const GladGLContext& context, std::span<const ShaderFile> files, std::string_view vertex_file,
          std::string_view fragment_file, std::span<const std::string_view> defines = {});
  ~Program();
  Program(Program&& other) noexcept;

  /// Makes this the program in use.
  void use() const { gl_->UseProgram(program_); }
  /// Set a uniform. The program must be in use. Unknown names are ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::ivec4& value) const;
  /// Sets the binding point of a uniform block; ignored if the program has no such block.
  void bind_block(const char* block, unsigned binding) const;

 private:
  const GladGLContext* gl_;
  GLuint program_ = 0;
};

// Binding point of the uniform block, and texture units of the samplers that several passes share.

inline constexpr unsigned frame_block_binding = 0;

inline constexpr unsigned key_map_unit = 0;
inline constexpr unsigned key_depth_unit = 1;
inline constexpr unsigned ground_light_unit = 2;
inline constexpr unsigned scalar_maps_unit = 3;
inline constexpr unsigned drawn_unit = 4;
inline constexpr unsigned visibility_unit = 5;
inline constexpr unsigned vertex_data_unit = 6;
inline constexpr unsigned triangle_data_unit = 7;
inline constexpr unsigned material_data_unit = 8;
inline constexpr unsigned floor_shadow_unit = 9;
inline constexpr unsigned halved_unit = 10;
inline constexpr unsigned base_colour_maps_unit = 11;
inline constexpr unsigned corner_data_unit = 12;
inline constexpr unsigned trim_data_unit = 13;
inline constexpr unsigned sky_maps_unit = 14;
inline constexpr unsigned behind_unit = 15;
inline constexpr unsigned marks_unit = 16;
inline constexpr unsigned vertex_light_unit = 17;
inline constexpr unsigned unit_count = 18;

/// Sets the uniform block and the samplers of a program to these bindings and leaves the program in use.
void bind_shared_inputs(const Program& program);

/// Program compiled at its first use, since a picture needs few of all programs. Its shaders are embedded_shaders();
/// the texts must outlive this object.
class LazyProgram {
 public:
  LazyProgram(const GladGLContext& context, std::string_view vertex_file, std::string_view fragment_file,
              std::vector<std::string_view> define_names = {})
      : gl_(&context), vertex_(vertex_file), fragment_(fragment_file), defines_(std::move(define_names)) {}

  /// Returns the program in use, with shared inputs bound. Throws ShaderError.
  const Program& use();

 private:
  const GladGLContext* gl_;
  std::string_view vertex_;
  std::string_view fragment_;
  std::vector<std::string_view> defines_;
  std::optional<Program> program_;
};

/// Largest number of pairs of opposite directions of the sky; shaders/frame.glsl has it too.
inline constexpr std::size_t max_sky_pairs = 16;

/// Uniforms shared by all shaders: the std140 block `Frame` of shaders/frame.glsl, which documents each member.
struct FrameBlock {
  glm::mat4 world_to_clip;
  glm::mat4 world_to_shadow;
  glm::vec4 eye;
  glm::vec4 towards_key;
  glm::vec4 towards_fill;
  glm::vec4 towards_rim;
  glm::vec4 upper_colour;
  glm::vec4 lower_colour;
  glm::vec4 ground;
  glm::vec4 viewport;
  glm::vec4 shadow;
  glm::vec4 shadow_blur;
  glm::vec4 shadow_bounds;
  glm::vec4 ground_light_area;
  glm::vec4 backdrop_horizon;
  glm::vec4 ray_corner;
  glm::vec4 ray_across;
  glm::vec4 ray_up;
  std::array<glm::mat4, max_sky_pairs> world_to_sky;
  std::array<glm::vec4, max_sky_pairs> towards_sky;
  glm::vec4 sky_floor;
  glm::vec4 sky_maps_shape;
};

/// Part of the picture that is drawn at once, in pixels of the finished picture, y from its top.
struct Tile {
  int x_px = 0;
  int y_px = 0;
  int width_px = 0;
  int height_px = 0;
};

/// Rectangle of a framebuffer in its pixels, y from the lower edge.
struct PixelRect {
  int x_px = 0;
  int y_px = 0;
  int width_px = 0;
  int height_px = 0;
};

/// Returns the side of the shadow map in texels: settings.shadow_map_px, or less for a small picture, which could not
/// show the difference.
int shadow_map_side(const PictureSettings& settings);

/// Returns the block without shadow_bounds and tile members. `casters`: the box around all shadow casters, metres; none
/// without casters.
FrameBlock make_frame_block(const FrameView& frame, const PictureSettings& settings, const std::optional<Box>& casters);

/// Sets shadow_bounds to the bounds of the casters in the shadow map.
void set_shadow_bounds(FrameBlock& block, std::span<const SurfaceView> casters);

/// Sets world_to_clip, viewport and the rays for a tile. The picture moves by `offset_px` drawn pixels.
void set_tile(FrameBlock& block, const Camera& camera, const PictureSettings& settings, const Tile& tile,
              const glm::vec2& offset_px = glm::vec2{0.0F});

/// Returns the matrix of an orthographic view of the sphere around the box, from world to 0..1 in all three axes.
/// `towards` is the unit direction to the viewer; depth (z) grows away from it.
glm::mat4 world_to_unit_cube(const Box& box, const glm::vec3& towards);

}  // namespace taut::renderer
