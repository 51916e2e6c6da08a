// Percentage-closer soft shadows (Fernando 2005): the penumbra widens with the distance to the caster.
#include "disc.glsl"
uniform sampler2DShadow shadow_compare;
uniform sampler2D shadow_depth;

// Samples that search for blockers. More find narrow ones but cost time in every pixel that may be in shadow.
const int search_taps = 6;
// Narrowest search and narrowest blur, texels of the map. With lower values the map's texels show.
const float narrowest_search = 2.5;
const float narrowest_blur = 1.5;
// Motion of a point along its normal, texels: on a surface that faces the light, and the addition on a grazing one.
// Higher values detach shadows from casters, lower ones give acne.
const float lift_facing = 0.6;
const float lift_grazing = 1.8;
// Smallest distance of a blocker in front of the point, texels. Lower values give acne.
const float blocker_allowance = 0.5;
// Tolerance of wide filters for a slanted surface itself, in texels per texel of radius.
const float slope_allowance = 0.15;

// Returns a direction by interleaved gradient noise (Jimenez 2014): neighbours differ as much as possible, so the eye
// averages them. It goes around a square instead of a circle and is then normalised, so directions are nearly uniform.
vec2 pixel_direction() {
  float h = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return normalize(abs(4.0 * fract(vec2(h, h + 0.25)) - 2.0) - 1.0 + 1e-4);
}

// Returns the fraction of the key light at a place of the map, if `open`. `slope` is the sine of the angle between the
// light and the surface's normal. A software rasteriser skips no branch but ends loops early; a test before the loop
// would cost one more pass.
float searched_visibility(vec3 place, float slope, float search_radius, float depth_to_uv, bool open) {
  vec2 first = pixel_direction();
  float blockers = 0.0;
  float depth_sum = 0.0;
  vec2 direction = first;
  int i = 0;
  do {
    // Samples are denser in the middle, for the narrow blur near casters.
    vec2 tap = place.xy + search_radius * ((float(i) + 0.5) / float(search_taps)) * direction;
    float depth = textureLod(shadow_depth, tap, 0.0).r;
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
    lit += textureLod(shadow_compare, vec3(tap, place.z - allowance), 0.0);
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
  vec3 lifted = position + normal * (shadow.x * (lift_facing + lift_grazing * slope) + shadow_blur.w);
  vec3 place = (world_to_shadow * vec4(lifted, 1.0)).xyz;
  place.z = min(place.z, 1.0);
  float depth_to_uv = shadow.z * shadow.w / shadow.x * shadow.y;  // blur radius per unit of the depth gap
  float search_radius = clamp(place.z * depth_to_uv, narrowest_search * shadow.y, shadow_blur.x * shadow.y);
  vec4 to_bounds = vec4(place.xy - shadow_bounds.xy, shadow_bounds.zw - place.xy);
  bool open = asked && shadow.w > 0.0 && all(greaterThan(to_bounds, vec4(-search_radius)));
  return searched_visibility(place, slope, search_radius, depth_to_uv, open);
}
