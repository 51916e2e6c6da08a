// The studio's floor in linear light; it blends into the backdrop before it ends.
// Smallest ambient light: bounced light keeps the darkest contact from going black.
const float least_open = 0.2;
// Tint of the darkest floor: shadows are slightly blue.
const vec3 shadow_tint = vec3(0.96, 0.98, 1.03);
// Start and end of the blend of floor and backdrop, and edge of the pool of light, as fractions of the floor's radius.
const float blend_start = 0.35;
const float blend_end = 0.95;
const float pool_edge = 0.5;
uniform sampler2D ground_light;  // visible fraction of the sky per spot of the floor

float floor_openness(vec3 spot) {
  return texture(ground_light, (spot.xz - ground_light_area.xy) * ground_light_area.zw).r;
}

// Returns 1 at the lower edge and the sides of the picture and 0 farther inside, so that no shadow is cut. `place`: in
// the tile, drawn pixels. The margin is a fraction of the picture's height.
const float shadow_fade = 0.14;
float shadow_fading(vec2 place) {
  vec2 in_picture = place + vec2(ray_corner.w, ray_up.w);
  float from_edge = min(in_picture.y, min(in_picture.x, ray_across.w - in_picture.x)) / viewport.w;
  return 1.0 - smoothstep(0.0, shadow_fade, from_edge);
}

// Returns the floor's colour. `lit`: fraction of the key light that arrives; `open`: visible fraction of the sky;
// `direction`: unit, from the eye to the spot.
vec3 floor_colour(vec3 spot, vec3 direction, float lit, float open) {
  float light = key_share * lit + (1.0 - key_share) * mix(least_open, 1.0, open);
  float away = length(spot.xz - ground.xz) / ground.w;
  vec3 pool = mix(lower_colour.rgb, upper_colour.rgb, far_floor * smoothstep(0.0, pool_edge, away));
  vec3 shaded = pool * mix(shadow_tint, vec3(1.0), light) * light;
  return mix(shaded, backdrop_colour(direction), smoothstep(blend_start, blend_end, away));
}
