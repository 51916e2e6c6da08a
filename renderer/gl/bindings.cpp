#include "renderer/gl/bindings.hpp"

namespace taut::renderer {

void bind_shared_inputs(const Program& program) {
  program.bind_block("Frame", frame_block_binding);
  program.use();
  program.set("shadow_compare", static_cast<int>(shadow_compare_unit));
  program.set("shadow_depth", static_cast<int>(shadow_depth_unit));
  program.set("ground_light", static_cast<int>(ground_light_unit));
  program.set("scalar_maps", static_cast<int>(scalar_maps_unit));
  program.set("drawn", static_cast<int>(drawn_unit));
  program.set("seen_map", static_cast<int>(seen_unit));
  program.set("halved", static_cast<int>(halved_unit));
  program.set("floor_shadow", static_cast<int>(floor_shadow_unit));
  program.set("vertex_table", static_cast<int>(vertex_table_unit));
  program.set("triangle_table", static_cast<int>(triangle_table_unit));
  program.set("look_table", static_cast<int>(look_table_unit));
}

}  // namespace taut::renderer
