#version 330 core
#include "frame.glsl"
#include "backdrop.glsl"
#include "floor.glsl"
// Backdrop and floor, in the key light and in its shadow. Nothing there changes from pixel to pixel, so it is drawn
// coarse and stretched by backdrop.frag.
uniform vec4 coarse;  // x: drawn pixels for a texel; y: 1 with a floor
layout(location = 0) out vec4 in_light;   // encoded
layout(location = 1) out vec4 in_shadow;  // encoded

void main() {
  vec3 direction = normalize(ray_through(gl_FragCoord.xy * coarse.x));
  vec3 spot = eye.xyz + direction * ((ground.y - eye.y) / min(direction.y, -1e-6));
  bool floor_seen = coarse.y > 0.5 && direction.y < 0.0;
  vec3 behind = backdrop_colour(direction);
  vec3 lit = floor_seen ? floor_colour(spot, direction, 1.0) : behind;
  vec3 dark = floor_seen ? floor_colour(spot, direction, 0.0) : behind;
  in_light = vec4(linear_to_srgb_fast(lit), 1.0);
  in_shadow = vec4(linear_to_srgb_fast(dark), 1.0);
}
