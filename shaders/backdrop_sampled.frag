#version 330 core
#include "frame.glsl"
#include "backdrop.glsl"
#include "floor.glsl"
#include "light_maps.glsl"
// Backdrop and floor in the light of one pass, for two by two pixels at a time: both are smooth, and film.frag
// interpolates.
// Fraction of the light on cloth that it returns to the floor below it, where it hides the sky.
const float cloth_bounce = 0.12;
layout(location = 0) out vec4 colour;  // linear

void main() {
  vec2 place = 2.0 * gl_FragCoord.xy;
  vec3 direction = normalize(ray_through(place));
  vec3 seen = backdrop_colour(direction);
  if (sky_floor.x > 0.5 && direction.y < 0.0) {
    vec3 up = vec3(0.0, 1.0, 0.0);
    vec3 spot = eye.xyz + direction * ((ground.y - eye.y) / min(direction.y, -1e-6));
    float open = sky_over_floor(spot);
    seen = floor_colour(spot, direction, mix(key_arriving(spot, up), 1.0, shadow_fading(place)), open) +
           cloth_bounce * max(1.0 - open, 0.0) * sky_floor.yzw * lower_colour.rgb;
  }
  colour = backdrop_horizon.z > 0.5 ? vec4(vec3(0.0), 1.0 - linear_to_srgb_fast(seen).g) : vec4(seen, 1.0);
}
