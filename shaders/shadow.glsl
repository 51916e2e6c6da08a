// Percentage-closer soft shadows (Fernando 2005): the penumbra widens with the distance to the caster. Every pixel takes
// the same samples, each a comparison with four texels, so that penumbrae are smooth.
#include "light_maps.glsl"
uniform sampler2DArray key_depth;

// Narrowest search and narrowest blur, texels of the map. With lower values the map's texels show.
const float narrowest_search = 3.0;
const float narrowest_blur = 1.2;
// Samples that search for blockers, and the widest blur as a fraction of the widest on the floor. More samples find
// narrow blockers, and the outer edge of wide penumbrae, but cost time in every pixel that may be in shadow.
#ifdef FLOOR
const int search_taps = 14;
const float widest_blur = 1.0;
#else
const int search_taps = 8;
const float widest_blur = 0.2;
#endif
// Smallest distance of a blocker in front of the point, texels. Lower values give acne.
const float blocker_allowance = 0.8;
// Steepest plane of a surface that its own samples follow, depth per width. Higher values give acne where the light
// grazes, lower ones show the surface's own shadow.
const float steepest = 4.0;

// Returns the direction of the first sample. On the floor neighbours have four, which the filter of backdrop.frag
// averages exactly.
vec2 first_direction() {
#ifdef FLOOR
  ivec2 place = ivec2(gl_FragCoord.xy) & 1;
  float turn = 0.39 + 1.5707963 * float(place.x + 2 * place.y);
  return vec2(cos(turn), sin(turn));
#else
  return vec2(0.924, 0.383);
#endif
}

// Returns the fraction of the key light at a place of the map, if `open`. `tilt`: change of the surface's depth across
// the map, so that a slanted surface does not count as its own blocker. A software rasteriser skips no branch but ends
// loops early; a test before the loop would cost one more pass.
float searched_visibility(vec3 place, vec2 tilt, float search_radius, float depth_to_uv, bool open) {
  vec2 first = first_direction();
  float blockers = 0.0;
  float depth_sum = 0.0;
  vec2 direction = first;
  int i = 0;
  do {
    // Samples are denser in the middle, for the narrow blur near casters.
    vec2 offset = search_radius * ((float(i) + 0.5) / float(search_taps)) * direction;
    float depth = textureLod(key_depth, vec3(place.xy + offset, 0.0), 0.0).r;
    direction = golden_turn * direction;
    float closer = step(depth, place.z + dot(tilt, offset) - blocker_allowance * shadow.x / shadow.z);
    blockers += closer;
    depth_sum += closer * depth;
    ++i;
  } while (i < (open ? search_taps : 0));
  blockers = open ? blockers : 0.0;
  float gap = place.z - depth_sum / max(blockers, 1.0);
  float radius = clamp(gap * depth_to_uv, narrowest_blur * shadow.y, widest_blur * shadow_blur.x * shadow.y);
#ifdef FLOOR
  int filter_taps = int(shadow_blur.z);
#else
  int filter_taps = int(shadow_blur.y);
#endif
  // If a wide search finds only blockers, a wide filter would too. It does not predict a narrow filter, nor all of the
  // many samples on the floor: single pixels would be darker than their neighbours.
#ifdef FLOOR
  const bool dark = false;
#else
  bool dark = blockers == float(search_taps) && radius > 0.5 * search_radius;
#endif
  bool mixed = blockers > 0.0 && !dark;
  float lit = 0.0;
  direction = first;
  i = 0;
  do {
    vec2 offset = radius * disc_radius(i, filter_taps) * direction;
    direction = golden_turn * direction;
    lit += texture(key_map, vec4(place.xy + offset, 0.0, min(place.z + dot(tilt, offset), 1.0)));
    ++i;
  } while (i < (mixed ? filter_taps : 0));
  return mixed ? lit / float(filter_taps) : 1.0 - step(0.5, blockers);
}

// Returns 1 in the light, 0 in the shadow; 1 unless `asked`. `normal` points to the lit side.
float key_visibility(vec3 position, vec3 normal, bool asked) {
  // The lift is along the normal, not towards the light: grazing surfaces need it most, and a thin cloth keeps its
  // shadow attached.
  float cosine = dot(normal, towards_key.xyz);
  vec3 facing = mat3(world_to_shadow) * normal;
  vec2 tilt = facing.xy / max(-facing.z, length(facing.xy) / steepest);
  vec3 place = (world_to_shadow * vec4(lifted(position, normal, cosine, shadow.x), 1.0)).xyz;
  place.z = min(place.z, 1.0);
  float depth_to_uv = shadow.z * shadow.w / shadow.x * shadow.y;  // blur radius per unit of the depth gap
  float widest = widest_blur * shadow_blur.x * shadow.y;
  float search_radius = clamp(place.z * depth_to_uv, narrowest_search * shadow.y, widest);
  vec4 to_bounds = vec4(place.xy - shadow_bounds.xy, shadow_bounds.zw - place.xy);
  bool open = asked && shadow.w > 0.0 && all(greaterThan(to_bounds, vec4(-search_radius)));
  return searched_visibility(place, tilt, search_radius, depth_to_uv, open);
}
