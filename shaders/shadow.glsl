// Percentage-closer soft shadows (Fernando 2005): the penumbra widens with the distance to what casts it.
#include "disc.glsl"
uniform sampler2DShadow shadow_compare;
uniform sampler2D shadow_depth;

const int search_taps = 6;
const int filter_taps = 14;
const float widest = 24.0;  // largest blur radius, texels

// Interleaved gradient noise (Jimenez 2014): neighbours differ as much as possible, so the eye averages them.
// Around a square instead of a circle, then back to length 1: near enough to all directions alike.
vec2 pixel_direction() {
  float h = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return normalize(abs(4.0 * fract(vec2(h, h + 0.25)) - 2.0) - 1.0 + 1e-4);
}

// 1 in the light, 0 in the shadow. `normal` points to the lit side. The loops are where the time goes: they end at
// once where there is nothing to find, which is the only kind of branch that a software rasteriser profits from.
float key_visibility(vec3 position, vec3 normal) {
  // Along the normal rather than towards the light: grazing surfaces need it most, and a thin cloth keeps its
  // shadow attached. More would lift the shadow off, less gives acne.
  float cosine = dot(normal, towards_key.xyz);
  float slope = sqrt(max(1.0 - cosine * cosine, 0.0));
  vec3 lifted = position + normal * shadow.x * (0.6 + 1.8 * slope);
  vec3 place = (world_to_shadow * vec4(lifted, 1.0)).xyz;
  place.z = min(place.z, 1.0);
  bool inside = all(lessThan(abs(place.xy - 0.5), vec2(0.5 + widest * shadow.y)));
  int searched = shadow.w > 0.0 && inside ? search_taps : 0;
  vec2 first = pixel_direction();
  float depth_to_uv = shadow.z * shadow.w / shadow.x * shadow.y;  // blur radius per unit of depth between
  float search_radius = clamp(place.z * depth_to_uv, 2.5 * shadow.y, widest * shadow.y);
  float blockers = 0.0;
  float depth_sum = 0.0;
  vec2 direction = first;
  for (int i = 0; i < searched; ++i) {
    vec2 tap = place.xy + search_radius * disc_radius(i, search_taps) * direction;
    float depth = textureLod(shadow_depth, tap, 0.0).r;
    direction = golden_turn * direction;
    float closer = step(depth, place.z - 0.5 * shadow.x / shadow.z);
    blockers += closer;
    depth_sum += closer * depth;
  }
  float gap = blockers > 0.0 ? place.z - depth_sum / blockers : 0.0;
  float radius = clamp(gap * depth_to_uv, 1.5 * shadow.y, widest * shadow.y);
  // A wide filter on a slanted surface would meet the surface itself: the allowance grows with the radius.
  float allowance = (radius / shadow.y) * 0.15 * slope * shadow.x / shadow.z;
  int filtered = blockers > 0.0 ? filter_taps : 0;
  float lit = 0.0;
  direction = first;
  for (int i = 0; i < filtered; ++i) {
    vec2 tap = place.xy + radius * disc_radius(i, filter_taps) * direction;
    direction = golden_turn * direction;
    lit += textureLod(shadow_compare, vec3(tap, place.z - allowance), 0.0);
  }
  return filtered > 0 ? lit / float(filter_taps) : 1.0;
}
