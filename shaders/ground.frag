#version 330 core
#include "frame.glsl"
#include "backdrop.glsl"
#include "floor.glsl"
#include "shadow.glsl"
in vec3 world;
layout(location = 0) out vec4 colour;  // encoded

void main() {
  float lit = key_visibility(world, vec3(0.0, 1.0, 0.0));
  colour = vec4(linear_to_srgb_fast(floor_colour(world, normalize(world - eye.xyz), lit)), 1.0);
}
