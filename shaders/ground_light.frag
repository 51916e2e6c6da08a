#version 330 core
#include "frame.glsl"
#include "sky.glsl"
uniform sampler2D sky_depth;
in vec2 place;
layout(location = 0) out vec4 light;

// A direction stands for a whole cone of sky, so its shadow softens with the distance to what casts it.
float soft_visibility(int i, vec3 position) {
  vec3 place = (world_to_sky[i] * vec4(position, 1.0)).xyz;
  vec4 cell = sky_cell(i);
  const int search_taps = 10;
  const int taps = 24;
  float widest = min(sky_blur.x * place.z, 0.5);
  vec2 direction = disc_direction(float(i));
  float blockers = 0.0;
  float depth_sum = 0.0;
  for (int k = 0; k < search_taps; ++k) {
    vec2 tap = place.xy + widest * disc_radius(k, search_taps) * direction;
    tap = clamp(tap, sky_blur.y, 1.0 - sky_blur.y);
    direction = golden_turn * direction;
    float depth = textureLod(sky_depth, cell.xy + tap * cell.zw, 0.0).r;
    float closer = step(depth, place.z - 0.002);
    blockers += closer;
    depth_sum += closer * depth;
  }
  if (blockers < 0.5) return 1.0;
  float radius = clamp(sky_blur.x * (place.z - depth_sum / blockers), 1.5 * sky_blur.y, 0.5);
  return sky_visibility(i, position, radius, taps);
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
