// The studio's floor, in linear light; it runs into the backdrop before it ends.
uniform sampler2D ground_light;  // share of the sky each spot of the floor sees

// `lit`: how much of the key light arrives; `direction`: unit, from the eye to the spot.
vec3 floor_colour(vec3 spot, vec3 direction, float lit) {
  const float key_share = 0.42;
  float open = texture(ground_light, (spot.xz - ground_light_area.xy) * ground_light_area.zw).r;
  // What bounces around in the studio keeps the darkest contact from going black.
  float light = key_share * lit + (1.0 - key_share) * mix(0.2, 1.0, open);
  vec3 shaded = lower_colour.rgb * mix(vec3(0.96, 0.98, 1.03), vec3(1.0), light) * light;
  float away = length(spot.xz - ground.xz) / ground.w;
  return mix(shaded, backdrop_colour(direction), smoothstep(0.35, 0.95, away));
}
