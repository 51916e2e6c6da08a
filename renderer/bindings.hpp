#pragma once

#include "renderer/shader.hpp"

namespace taut::renderer {

// Which slot of the context each shared input of the shaders uses; one place, so that passes agree.

inline constexpr unsigned frame_block_binding = 0;

inline constexpr unsigned shadow_compare_unit = 0;
inline constexpr unsigned shadow_depth_unit = 1;
inline constexpr unsigned ground_light_unit = 2;
inline constexpr unsigned scalar_map_unit = 3;
inline constexpr unsigned drawn_unit = 4;
inline constexpr unsigned behind_unit = 5;
inline constexpr unsigned backdrop_map_unit = 6;
inline constexpr unsigned unit_count = 7;

/// Connects a program's uniform blocks and samplers to these slots.
void bind_shared_inputs(const Program& program);

}  // namespace taut::renderer
