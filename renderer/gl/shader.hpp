#pragma once

#include <glad/gl.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace taut::renderer {

/// A shader that does not compile or link. The message names the file and the line of every error.
struct ShaderError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One file of the shaders folder.
struct ShaderFile {
  std::string_view name;  ///< without folder: "surface.frag"
  std::string_view text;
};

/// All of them, as they were when the program was built.
std::span<const ShaderFile> embedded_shaders();

/// A vertex and a fragment shader, linked. `#include "file"` on a line of its own is replaced by that file,
/// once for each stage.
class Program {
 public:
  /// Names of the two files; `defines` are put below the #version line. Throws ShaderError.
  Program(const GladGLContext& context, std::span<const ShaderFile> files, std::string_view vertex_file,
          std::string_view fragment_file, std::span<const std::string_view> defines = {});
  ~Program();
  Program(Program&& other) noexcept;
  Program& operator=(Program&&) = delete;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use() const;
  /// For uniforms of the program in use; a name the compiler has optimised away is ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::ivec4& value) const;
  void set(const char* uniform, const glm::mat4& value) const;
  /// Which binding point a uniform block reads from; ignored when the program has no such block.
  void bind_block(const char* block, unsigned binding) const;

 private:
  const GladGLContext* gl;
  GLuint program = 0;
};

}  // namespace taut::renderer
