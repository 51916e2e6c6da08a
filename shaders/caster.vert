#version 330 core
#include "frame.glsl"
// Draws casters of shadows as a light sees them.
uniform int layer;  // 0: key lamp; then the upper and the lower direction of each pair of the sky
layout(location = 0) in vec3 position;  // m

void main() {
  mat4 world_to_map = layer == 0 ? world_to_shadow : world_to_sky[(layer - 1) / 2];
  vec3 place = 2.0 * (world_to_map * vec4(position, 1.0)).xyz - 1.0;
  gl_Position = vec4(place.xy, layer > 0 && layer % 2 == 0 ? -place.z : place.z, 1.0);
}
