#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "renderer/gl/shader.hpp"

namespace taut::renderer {

/// A program that is compiled when it is first used: a picture needs few of all there are. The names, and
/// what `files` looks at, have to outlive it.
class LazyProgram {
 public:
  LazyProgram(const GladGLContext& context, std::span<const ShaderFile> shader_files,
              std::string_view vertex_file, std::string_view fragment_file,
              std::span<const std::string_view> define_names = {})
      : gl(&context),
        files(shader_files),
        vertex(vertex_file),
        fragment(fragment_file),
        defines(define_names) {}

  /// Connected to the shared inputs of bindings.hpp and in use. Throws ShaderError.
  const Program& use();

 private:
  const GladGLContext* gl;
  std::span<const ShaderFile> files;
  std::string_view vertex;
  std::string_view fragment;
  std::span<const std::string_view> defines;
  std::optional<Program> program;
};

}  // namespace taut::renderer
