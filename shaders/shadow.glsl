// Percentage-closer soft shadows (Fernando 2005): the penumbra widens with the distance to what casts it.
uniform sampler2DShadow shadow_compare;
uniform sampler2D shadow_depth;

const int search_taps = 8;
const int filter_taps = 20;
const float golden_angle = 2.39996323;

// Evenly spread over the unit disc (Vogel 1979).
vec2 disc_point(int i, int count, float turn) {
  float radius = sqrt((float(i) + 0.5) / float(count));
  float angle = float(i) * golden_angle + turn;
  return radius * vec2(cos(angle), sin(angle));
}

// Interleaved gradient noise (Jimenez 2014): neighbours differ as much as possible, so the eye averages them.
float pixel_turn() {
  return 2.0 * pi * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}

// 1 in the light, 0 in the shadow. `normal` points to the lit side.
float key_visibility(vec3 position, vec3 normal) {
  if (shadow.w <= 0.0) return 1.0;
  // Along the normal rather than towards the light: grazing surfaces need it most, and a thin cloth keeps its
  // shadow attached. More would lift the shadow off, less gives acne.
  float slope = sqrt(max(1.0 - pow(dot(normal, towards_key.xyz), 2.0), 0.0));
  vec3 lifted = position + normal * shadow.x * (0.6 + 1.8 * slope);
  vec3 place = (world_to_shadow * vec4(lifted, 1.0)).xyz;
  place.z = min(place.z, 1.0);
  float turn = pixel_turn();
  float depth_to_uv = shadow.z * shadow.w / shadow.x * shadow.y;  // blur radius per unit of depth between
  float search_radius = clamp(place.z * depth_to_uv, 2.0 * shadow.y, 24.0 * shadow.y);
  float blockers = 0.0;
  float depth_sum = 0.0;
  for (int i = 0; i < search_taps; ++i) {
    float depth = textureLod(shadow_depth, place.xy + search_radius * disc_point(i, search_taps, turn), 0.0).r;
    float closer = step(depth, place.z - 0.5 * shadow.x / shadow.z);
    blockers += closer;
    depth_sum += closer * depth;
  }
  float gap = blockers > 0.0 ? place.z - depth_sum / blockers : 0.0;
  float radius = clamp(gap * depth_to_uv, 1.5 * shadow.y, 24.0 * shadow.y);
  // A wide filter on a slanted surface would meet the surface itself: the allowance grows with the radius.
  float allowance = (radius / shadow.y) * 0.15 * slope * shadow.x / shadow.z;
  float lit = 0.0;
  for (int i = 0; i < filter_taps; ++i) {
    vec2 tap = place.xy + radius * disc_point(i, filter_taps, turn);
    lit += textureLod(shadow_compare, vec3(tap, place.z - allowance), 0.0);
  }
  return lit / float(filter_taps);
}
