// Percentage-closer soft shadows (Fernando 2005): the penumbra widens with the distance to the caster. Every pixel takes
// the same samples, each a comparison with four texels, so that penumbrae are smooth.
#include "light_maps.glsl"
uniform sampler2DArray key_depth;

// Samples that search for blockers. More find narrow ones but cost time in every pixel that may be in shadow.
const int search_taps = 8;
// Narrowest search and narrowest blur, texels of the map. With lower values the map's texels show.
const float narrowest_search = 3.0;
const float narrowest_blur = 1.2;
// Smallest distance of a blocker in front of the point, texels. Lower values give acne.
const float blocker_allowance = 0.5;
// Tolerance of wide filters for a slanted surface itself, in texels per texel of radius.
const float slope_allowance = 0.15;

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

// Returns the fraction of the key light at a place of the map, if `open`. `slope` is the sine of the angle between the
// light and the surface's normal. A software rasteriser skips no branch but ends loops early; a test before the loop
// would cost one more pass.
float searched_visibility(vec3 place, float slope, float search_radius, float depth_to_uv, bool open) {
  vec2 first = first_direction();
  float blockers = 0.0;
  float depth_sum = 0.0;
  vec2 direction = first;
  int i = 0;
  do {
    // Samples are denser in the middle, for the narrow blur near casters.
    vec2 tap = place.xy + search_radius * ((float(i) + 0.5) / float(search_taps)) * direction;
    float depth = textureLod(key_depth, vec3(tap, 0.0), 0.0).r;
    direction = golden_turn * direction;
    float closer = step(depth, place.z - blocker_allowance * shadow.x / shadow.z);
    blockers += closer;
    depth_sum += closer * depth;
    ++i;
  } while (i < (open ? search_taps : 0));
  blockers = open ? blockers : 0.0;
  float gap = place.z - depth_sum / max(blockers, 1.0);
  float radius = clamp(gap * depth_to_uv, narrowest_blur * shadow.y, shadow_blur.x * shadow.y);
  // The tolerance grows with the radius, as wide filters on a slanted surface would hit the surface itself.
  float allowance = (radius / shadow.y) * slope_allowance * slope * shadow.x / shadow.z;
#ifdef FLOOR
  int filter_taps = int(shadow_blur.z);
#else
  int filter_taps = int(shadow_blur.y);
#endif
  // If a wide search finds only blockers, a wide filter would too. It does not predict a narrow filter.
  bool dark = blockers == float(search_taps) && radius > 0.5 * search_radius;
  bool mixed = blockers > 0.0 && !dark;
  float lit = 0.0;
  direction = first;
  i = 0;
  do {
    vec2 tap = place.xy + radius * disc_radius(i, filter_taps) * direction;
    direction = golden_turn * direction;
    lit += texture(key_map, vec4(tap, 0.0, place.z - allowance));
    ++i;
  } while (i < (mixed ? filter_taps : 0));
  return mixed ? lit / float(filter_taps) : 1.0 - step(0.5, blockers);
}

// Returns 1 in the light, 0 in the shadow; 1 unless `asked`. `normal` points to the lit side.
float key_visibility(vec3 position, vec3 normal, bool asked) {
  // The lift is along the normal, not towards the light: grazing surfaces need it most, and a thin cloth keeps its
  // shadow attached.
  float cosine = dot(normal, towards_key.xyz);
  float slope = sqrt(max(1.0 - cosine * cosine, 0.0));
  vec3 place = (world_to_shadow * vec4(lifted(position, normal, cosine, shadow.x), 1.0)).xyz;
  place.z = min(place.z, 1.0);
  float depth_to_uv = shadow.z * shadow.w / shadow.x * shadow.y;  // blur radius per unit of the depth gap
  float search_radius = clamp(place.z * depth_to_uv, narrowest_search * shadow.y, shadow_blur.x * shadow.y);
  vec4 to_bounds = vec4(place.xy - shadow_bounds.xy, shadow_bounds.zw - place.xy);
  bool open = asked && shadow.w > 0.0 && all(greaterThan(to_bounds, vec4(-search_radius)));
  return searched_visibility(place, slope, search_radius, depth_to_uv, open);
}
