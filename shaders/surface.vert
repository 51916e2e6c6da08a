#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float scalar;  // 0..1, below 0 for not a number
layout(location = 4) in vec3 material_coordinate;  // m
layout(location = 5) in vec2 arriving_sky;  // x: outside, y: inside
layout(location = 3) in float decided;  // of the key light: 1 in it, 0 in its shadow, 0.5 for pixels to find out
centroid out vec3 world;
centroid out vec3 world_normal;
centroid out float shown_scalar;
centroid out vec2 sky_light;  // x: outside, y: inside
centroid out float decided_shadow;
out vec3 material;

void main() {
  world = position;
  world_normal = normal;
  shown_scalar = scalar;
  decided_shadow = decided;
  material = material_coordinate;
  sky_light = arriving_sky;
  gl_Position = world_to_clip * vec4(position, 1.0);
}
