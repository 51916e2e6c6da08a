#pragma once

#include "renderer/gl/shader.hpp"

namespace taut::renderer {

// The binding point of the uniform block and the texture unit of each sampler that several passes share.

inline constexpr unsigned frame_block_binding = 0;

inline constexpr unsigned shadow_compare_unit = 0;
inline constexpr unsigned shadow_depth_unit = 1;
inline constexpr unsigned ground_light_unit = 2;
inline constexpr unsigned scalar_maps_unit = 3;
inline constexpr unsigned drawn_unit = 4;
inline constexpr unsigned visibility_unit = 5;
inline constexpr unsigned vertex_data_unit = 6;
inline constexpr unsigned triangle_data_unit = 7;
inline constexpr unsigned material_data_unit = 8;
inline constexpr unsigned floor_shadow_unit = 9;
inline constexpr unsigned halved_unit = 10;
inline constexpr unsigned base_colour_maps_unit = 11;
inline constexpr unsigned corner_data_unit = 12;
inline constexpr unsigned trim_data_unit = 13;
inline constexpr unsigned unit_count = 14;

/// Sets the uniform block and the samplers of a program to these bindings and leaves the program in use.
void bind_shared_inputs(const Program& program);

}  // namespace taut::renderer
