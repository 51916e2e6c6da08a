#include "renderer/gl/lazy_program.hpp"

#include "renderer/gl/bindings.hpp"

namespace taut::renderer {

const Program& LazyProgram::use() {
  if (!program_) {
    program_.emplace(*gl_, files_, vertex_, fragment_, defines_);
    bind_shared_inputs(*program_);
  }
  program_->use();
  return *program_;
}

}  // namespace taut::renderer
