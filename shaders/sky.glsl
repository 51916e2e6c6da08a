// Light from the whole studio around: bright from above, weaker from below, reduced by what stands in the way. Each
// direction has a small depth map in one atlas.
#include "disc.glsl"
const int max_sky_directions = 64;
layout(std140) uniform Sky {
  vec4 sky_info;                               // x: number of directions; y: columns; z: rows; w: lift, m
  vec4 sky_blur;                               // x: tangent of the cone each direction stands for; y: a texel
  vec4 sky_directions[max_sky_directions];     // xyz: unit, towards the light; w: its brightness
  mat4 world_to_sky[max_sky_directions];       // to 0..1 within the direction's own map
};
uniform sampler2DShadow sky_atlas;

// Corner and size of a direction's map in the atlas.
vec4 sky_cell(int i) {
  return vec4(mod(float(i), sky_info.y), floor(float(i) / sky_info.y), 1.0, 1.0) / sky_info.yzyz;
}

// Compared within the direction's own map only: filtering must not reach into the neighbours.
float sky_tap(vec4 cell, vec2 place, float depth) {
  vec2 inside = clamp(place, sky_blur.y, 1.0 - sky_blur.y);
  return textureLod(sky_atlas, vec3(cell.xy + inside * cell.zw, depth), 0.0);
}

// What one direction lets through, softened over `radius` of its map.
float sky_visibility(int i, vec3 position, float radius, int taps) {
  vec3 place = (world_to_sky[i] * vec4(position, 1.0)).xyz;
  vec4 cell = sky_cell(i);
  float seen = 0.0;
  vec2 direction = disc_direction(float(i));
  for (int k = 0; k < taps; ++k) {
    seen += sky_tap(cell, place.xy + radius * disc_radius(k, taps) * direction, min(place.z, 1.0));
    direction = golden_turn * direction;
  }
  return seen / float(taps);
}

// An open studio, for when no directions are tested: the same integral without anything in the way.
float open_sky(vec3 normal) { return mix(0.5, 1.0, 0.5 + 0.5 * normal.y); }
