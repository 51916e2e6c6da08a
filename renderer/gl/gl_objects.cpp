#include "renderer/gl/gl_objects.hpp"

#include <glm/gtc/type_ptr.hpp>

namespace taut::renderer {
namespace {

std::string hexadecimal(GLenum value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%04X", value);
  return text;
}

// The names of samplers, by their units.
constexpr std::array<const char*, unit_count> samplers = {
    "shadow_compare", "shadow_depth",  "ground_light",  "scalar_maps",  "drawn",  "visibility_buffer",
    "vertex_data",    "triangle_data", "material_data", "floor_shadow", "halved", "base_colour_maps",
    "corner_data",    "trim_data"};

std::string_view text_of(std::span<const ShaderFile> files, std::string_view name) {
  for (const ShaderFile& file : files) {
    if (file.name == name) return file.text;
  }
  throw ShaderError("there is no shader file '" + std::string(name) + "'");
}

// The version stays the first line.
std::string with_defines(std::string_view text, std::string_view defines) {
  const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
  return std::string(text.substr(0, end)).append(defines).append("#line 2\n").append(text.substr(end));
}

// Drivers begin every line with the number of the source, 0: "0:12(5): error" (Mesa), "0(12) : error"
// (NVIDIA).
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
    const std::string source = with_defines(text_of(files, name), defines);
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

void Program::use() const { gl_->UseProgram(program_); }

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

}  // namespace taut::renderer
