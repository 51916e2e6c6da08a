// The studio's floor, in linear light; it runs into the backdrop before it ends.
// Share of the floor's light that comes from the key light. More darkens its shadow.
const float key_share = 0.42;
// Least light from all around: what bounces keeps the darkest contact from going black.
const float least_open = 0.2;
// Colour of the darkest floor, times its own: shadows are a little blue.
const vec3 shadow_tint = vec3(0.96, 0.98, 1.03);
// Where the floor starts to run into the backdrop and where it has, shares of its radius.
const float blend_start = 0.35;
const float blend_end = 0.95;
uniform sampler2D ground_light;  // share of the sky each spot of the floor sees

// `lit`: how much of the key light arrives; `direction`: unit, from the eye to the spot.
vec3 floor_colour(vec3 spot, vec3 direction, float lit) {
  float open = texture(ground_light, (spot.xz - ground_light_area.xy) * ground_light_area.zw).r;
  float light = key_share * lit + (1.0 - key_share) * mix(least_open, 1.0, open);
  vec3 shaded = lower_colour.rgb * mix(shadow_tint, vec3(1.0), light) * light;
  float away = length(spot.xz - ground.xz) / ground.w;
  return mix(shaded, backdrop_colour(direction), smoothstep(blend_start, blend_end, away));
}
