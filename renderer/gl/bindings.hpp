#pragma once

#include "renderer/gl/shader.hpp"

namespace taut::renderer {

// Which slot of the context each shared input of the shaders uses; one place, so that passes agree.

inline constexpr unsigned frame_block_binding = 0;

inline constexpr unsigned shadow_compare_unit = 0;
inline constexpr unsigned shadow_depth_unit = 1;
inline constexpr unsigned ground_light_unit = 2;
inline constexpr unsigned scalar_maps_unit = 3;
inline constexpr unsigned drawn_unit = 4;
inline constexpr unsigned seen_unit = 5;
inline constexpr unsigned vertex_table_unit = 6;
inline constexpr unsigned triangle_table_unit = 7;
inline constexpr unsigned look_table_unit = 8;
inline constexpr unsigned floor_shadow_unit = 9;
inline constexpr unsigned halved_unit = 10;
inline constexpr unsigned unit_count = 11;

/// Connects a program's uniform blocks and samplers to these slots.
void bind_shared_inputs(const Program& program);

}  // namespace taut::renderer
