#version 330 core
#include "frame.glsl"
#include "backdrop.glsl"
#ifdef SHADED
#include "shadow.glsl"
#endif
uniform sampler2D ground_light;  // share of the sky each spot of the floor sees
in vec3 world;
layout(location = 0) out vec4 colour;  // encoded

void main() {
  float key_share = 0.42;
#ifdef SHADED
  float lit = key_visibility(world, vec3(0.0, 1.0, 0.0));
#else
  float lit = 1.0;
#endif
  float open = texture(ground_light, (world.xz - ground_light_area.xy) * ground_light_area.zw).r;
  // What bounces around in the studio keeps the darkest contact from going black.
  float light = key_share * lit + (1.0 - key_share) * mix(0.2, 1.0, open);
  vec3 shaded = lower_colour.rgb * mix(vec3(0.96, 0.98, 1.03), vec3(1.0), light) * light;
  float away = length(world.xz - ground.xz) / ground.w;
  vec3 behind = backdrop_colour(normalize(world - eye.xyz));
  colour = vec4(linear_to_srgb_fast(mix(shaded, behind, smoothstep(0.35, 0.95, away))), 1.0);
}
