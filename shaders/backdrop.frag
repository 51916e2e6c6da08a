#version 330 core
#include "frame.glsl"
uniform mat4 clip_to_direction;
in vec2 place;
layout(location = 0) out vec4 colour;

void main() {
  vec4 far = clip_to_direction * vec4(place * 2.0 - 1.0, 1.0, 1.0);
  float rise = normalize(far.xyz).y;
  float t = smoothstep(backdrop_horizon.x, backdrop_horizon.y, rise);
  vec3 linear = mix(lower_colour.rgb, upper_colour.rgb, lower_colour.w > 0.5 ? 0.0 : t);
  colour = vec4(linear, 1.0);
}
