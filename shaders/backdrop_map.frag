#version 330 core
#include "frame.glsl"
#include "backdrop.glsl"
#include "floor.glsl"
// Backdrop and floor without the key light's shadow. Nothing there changes from pixel to pixel, so it is drawn
// coarse and stretched by backdrop.frag.
uniform mat4 clip_to_direction;
uniform vec4 coarse;  // x: drawn pixels for a texel; y: 1 with a floor
layout(location = 0) out vec4 colour;  // encoded

void main() {
  vec2 place = gl_FragCoord.xy * coarse.x / viewport.xy;
  vec3 direction = normalize((clip_to_direction * vec4(place * 2.0 - 1.0, 1.0, 1.0)).xyz);
  float distance_m = (ground.y - eye.y) / min(direction.y, -1e-6);
  vec3 floor_seen = floor_colour(eye.xyz + distance_m * direction, direction, 1.0);
  vec3 seen = coarse.y > 0.5 && direction.y < 0.0 ? floor_seen : backdrop_colour(direction);
  colour = vec4(linear_to_srgb_fast(seen), 1.0);
}
