#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "renderer/gl/shader.hpp"

namespace taut::renderer {

/// A Program that is compiled at its first use, since a picture needs few of all programs. The arguments are
/// as those of Program; what they point at must outlive this object.
class LazyProgram {
 public:
  LazyProgram(const GladGLContext& context, std::span<const ShaderFile> shader_files,
              std::string_view vertex_file, std::string_view fragment_file,
              std::span<const std::string_view> define_names = {})
      : gl_(&context),
        files_(shader_files),
        vertex_(vertex_file),
        fragment_(fragment_file),
        defines_(define_names) {}

  /// Returns the program, bound as in bindings.hpp and in use. Throws ShaderError.
  const Program& use();

 private:
  const GladGLContext* gl_;
  std::span<const ShaderFile> files_;
  std::string_view vertex_;
  std::string_view fragment_;
  std::span<const std::string_view> defines_;
  std::optional<Program> program_;
};

}  // namespace taut::renderer
