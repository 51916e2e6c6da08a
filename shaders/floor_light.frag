#version 330 core
#include "frame.glsl"
#include "light_maps.glsl"
// Visible fraction of the sky on the floor around the casters; it fades out towards the edge of the texture.
const float side_px = 56.0;  // renderer/light/studio_light.cpp has it too
const float fade_start = 0.75;
layout(location = 0) out float open;

void main() {
  vec2 place = gl_FragCoord.xy / side_px;
  vec2 spot = ground_light_area.xy + place / ground_light_area.zw;
  vec2 edge = abs(2.0 * place - 1.0);
  open = mix(sky_over_floor(vec3(spot.x, ground.y, spot.y)), 1.0, smoothstep(fade_start, 1.0, max(edge.x, edge.y)));
}
