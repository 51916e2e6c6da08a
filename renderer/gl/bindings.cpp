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

}  // namespace taut::renderer
