#version 330 core
#include "frame.glsl"
#include "sky.glsl"
in vec2 place;
layout(location = 0) out vec4 light;

void main() {
  vec2 spot = ground_light_area.xy + place / ground_light_area.zw;
  vec3 world = vec3(spot.x, ground.y + 0.5 * sky_info.w, spot.y);
  float seen = 0.0;
  float all = 0.0;
  for (int i = 0; i < int(sky_info.x); ++i) {
    float weight = max(sky_directions[i].y, 0.0);
    seen += weight * sky_visibility(i, world);
    all += weight;
  }
  // The texture ends somewhere; fading out beforehand hides where.
  vec2 edge = abs(place * 2.0 - 1.0);
  float fade = smoothstep(0.75, 1.0, max(edge.x, edge.y));
  light = vec4(vec3(mix(seen / all, 1.0, fade)), 1.0);
}
