#include "renderer/bindings.hpp"

namespace taut::renderer {

void bind_shared_inputs(const Program& program) {
  program.bind_block("Frame", frame_block_binding);
  program.use();
  program.set("shadow_compare", static_cast<int>(shadow_compare_unit));
  program.set("shadow_depth", static_cast<int>(shadow_depth_unit));
  program.set("ground_light", static_cast<int>(ground_light_unit));
  program.set("scalar_map", static_cast<int>(scalar_map_unit));
  program.set("drawn", static_cast<int>(drawn_unit));
  program.set("behind", static_cast<int>(behind_unit));
  program.set("backdrop_map", static_cast<int>(backdrop_map_unit));
}

}  // namespace taut::renderer
