#version 330 core
#include "frame.glsl"
#include "sky.glsl"
in vec2 place;
layout(location = 0) out vec4 light;

// A direction stands for a whole cone of sky, so its shadow softens with the distance to what casts it. That distance
// is taken as if all casters stood in the middle of the map: searching for them gives every spot another softness,
// which shows as clouds. Wider than the cone, so that neighbouring directions run into each other.
float soft_visibility(int i, vec3 position) {
  float depth = (world_to_sky[i] * vec4(position, 1.0)).z;
  float radius = clamp(1.7 * sky_blur.x * (depth - 0.5), 1.5 * sky_blur.y, 0.5);
  return sky_visibility(i, position, radius, 32);
}

void main() {
  vec2 spot = ground_light_area.xy + place / ground_light_area.zw;
  vec3 world = vec3(spot.x, ground.y + 0.5 * sky_info.w, spot.y);
  float seen = 0.0;
  float all = 0.0;
  for (int i = 0; i < int(sky_info.x); ++i) {
    float weight = sky_directions[i].y;
    if (weight <= 0.0) break;  // directions come from the top down
    seen += weight * soft_visibility(i, world);
    all += weight;
  }
  // The texture ends somewhere; fading out beforehand hides where.
  vec2 edge = abs(place * 2.0 - 1.0);
  float fade = smoothstep(0.75, 1.0, max(edge.x, edge.y));
  light = vec4(vec3(mix(seen / all, 1.0, fade)), 1.0);
}
