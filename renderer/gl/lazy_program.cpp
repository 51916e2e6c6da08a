#include "renderer/gl/lazy_program.hpp"

#include "renderer/gl/bindings.hpp"

namespace taut::renderer {

const Program& LazyProgram::use() {
  if (!program) {
    program.emplace(*gl, files, vertex, fragment, defines);
    bind_shared_inputs(*program);
  }
  program->use();
  return *program;
}

}  // namespace taut::renderer
