#pragma once

#include <glad/gl.h>

#include <glm/vec4.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace taut::renderer {

/// A shader does not compile or link. The message names the file and the line of every error.
struct ShaderError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One file of the shaders folder.
struct ShaderFile {
  std::string_view name;  ///< without folder, e.g. "surface.frag"
  std::string_view text;  ///< the source
};

/// Returns all files of the shaders folder, as they were when the program was built.
std::span<const ShaderFile> embedded_shaders();

/// A linked vertex and fragment shader. A line `#include "file"` is replaced by that file, once per stage.
class Program {
 public:
  /// Compiles two of `files`, by name. Each of `defines` is defined in both. Throws ShaderError.
  Program(const GladGLContext& context, std::span<const ShaderFile> files, std::string_view vertex_file,
          std::string_view fragment_file, std::span<const std::string_view> defines = {});
  ~Program();
  Program(Program&& other) noexcept;
  Program& operator=(Program&&) = delete;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Makes this the program in use.
  void use() const;
  /// Set a uniform. The program must be in use. A name that the program does not have is ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::ivec4& value) const;
  /// Sets the binding point of a uniform block; ignored when the program has no such block.
  void bind_block(const char* block, unsigned binding) const;

 private:
  const GladGLContext* gl_;
  GLuint program_ = 0;
};

}  // namespace taut::renderer
