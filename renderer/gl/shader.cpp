#include "renderer/gl/shader.hpp"

#include <algorithm>
#include <cctype>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

namespace taut::renderer {
namespace {

// A stage's source with the names of its files; the index of a name is the source number in #line.
struct Assembled {
  std::string text;
  std::vector<std::string> names;
};

std::string_view text_of(std::span<const ShaderFile> files, std::string_view name,
                         std::string_view wanted_by) {
  for (const ShaderFile& file : files) {
    if (file.name == name) return file.text;
  }
  throw ShaderError("there is no shader file '" + std::string(name) + "', needed by '" +
                    std::string(wanted_by) + "'");
}

std::string_view included_file(std::string_view line) {
  constexpr std::string_view start = "#include \"";
  if (!line.starts_with(start)) return {};
  line.remove_prefix(start.size());
  return line.substr(0, line.find('"'));
}

void append_file(Assembled& out, std::span<const ShaderFile> files, std::string_view name,
                 std::string_view wanted_by, std::string_view defines) {
  if (std::find(out.names.begin(), out.names.end(), name) != out.names.end()) return;
  std::string_view text = text_of(files, name, wanted_by);
  const std::size_t number = out.names.size();
  out.names.emplace_back(name);
  const auto mark_line = [&out, number](int line) {
    out.text += "#line " + std::to_string(line) + " " + std::to_string(number) + "\n";
  };
  // The version has to stay the very first line.
  if (number > 0) mark_line(1);
  for (int line_number = 1; !text.empty(); ++line_number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    const std::string_view include = included_file(line);
    if (include.empty()) {
      out.text.append(line).append("\n");
    } else {
      append_file(out, files, include, name, {});
      mark_line(line_number + 1);
    }
    if (line.starts_with("#version")) {
      out.text.append(defines);
      mark_line(line_number + 1);
    }
  }
}

// Drivers write "0:12(5): error" (Mesa) or "0(12) : error" (NVIDIA): the source number leads every line.
std::string with_file_names(const std::string& log, const std::vector<std::string>& names) {
  std::string out;
  std::size_t start = 0;
  while (start < log.size()) {
    const std::size_t end = std::min(log.find('\n', start), log.size());
    std::string line = log.substr(start, end - start);
    start = end + 1;
    std::size_t digits = 0;
    while (digits < line.size() && std::isdigit(static_cast<unsigned char>(line[digits])) != 0) ++digits;
    const bool led =
        digits > 0 && digits < 4 && digits < line.size() && (line[digits] == ':' || line[digits] == '(');
    if (led) {
      const std::size_t number = std::stoul(line.substr(0, digits));
      if (number < names.size()) line.replace(0, digits, names[number]);
    }
    out += "\n  " + line;
  }
  return out;
}

template <typename GetValue, typename GetLog>
std::string info_log(GLuint object, GetValue get_value, GetLog get_log) {
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
    Assembled source;
    append_file(source, files, name, name, defines);
    const char* text = source.text.c_str();
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    GLint compiled = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return;
    const std::string log = info_log(shader, gl.GetShaderiv, gl.GetShaderInfoLog);
    throw ShaderError("the shader '" + std::string(name) +
                      "' does not compile:" + with_file_names(log, source.names));
  }
};

}  // namespace

Program::Program(const GladGLContext& context, std::span<const ShaderFile> files,
                 std::string_view vertex_file, std::string_view fragment_file,
                 std::span<const std::string_view> defines)
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

void Program::use() const {
  gl_->UseProgram(program_);
}

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
  program.set("shadow_compare", static_cast<int>(shadow_compare_unit));
  program.set("shadow_depth", static_cast<int>(shadow_depth_unit));
  program.set("ground_light", static_cast<int>(ground_light_unit));
  program.set("scalar_maps", static_cast<int>(scalar_maps_unit));
  program.set("drawn", static_cast<int>(drawn_unit));
  program.set("visibility_buffer", static_cast<int>(visibility_unit));
  program.set("halved", static_cast<int>(halved_unit));
  program.set("base_colour_maps", static_cast<int>(base_colour_maps_unit));
  program.set("corner_data", static_cast<int>(corner_data_unit));
  program.set("floor_shadow", static_cast<int>(floor_shadow_unit));
  program.set("vertex_data", static_cast<int>(vertex_data_unit));
  program.set("triangle_data", static_cast<int>(triangle_data_unit));
  program.set("material_data", static_cast<int>(material_data_unit));
  program.set("trim_data", static_cast<int>(trim_data_unit));
}

const Program& LazyProgram::use() {
  if (!program_) {
    program_.emplace(*gl_, files_, vertex_, fragment_, defines_);
    bind_shared_inputs(*program_);
  }
  program_->use();
  return *program_;
}

}  // namespace taut::renderer
