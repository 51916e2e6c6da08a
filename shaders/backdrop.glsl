// Part of the way from the lower to the upper colour that the floor takes far from the lamps, where the wall starts.
const float far_floor = 0.45;

// Returns the backdrop in linear light for a unit direction from the eye.
vec3 backdrop_colour(vec3 direction) {
  float t = mix(far_floor, 1.0, smoothstep(backdrop_horizon.x, backdrop_horizon.y, direction.y));
  return mix(lower_colour.rgb, upper_colour.rgb, lower_colour.w > 0.5 ? 0.0 : t);
}
