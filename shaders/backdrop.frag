#version 330 core
#include "frame.glsl"
#include "backdrop.glsl"
uniform mat4 clip_to_direction;
in vec2 place;
layout(location = 0) out vec4 colour;  // encoded

void main() {
  vec4 direction = clip_to_direction * vec4(place * 2.0 - 1.0, 1.0, 1.0);
  colour = vec4(linear_to_srgb_fast(backdrop_colour(normalize(direction.xyz))), 1.0);
}
