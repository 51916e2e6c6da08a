// Light of one pass of many: from a point of the key lamp, and from pairs of opposite directions of the sky.
// Layers: the key lamp, then the upper and the lower direction of each pair.
uniform sampler2DArrayShadow light_maps;

// Motion of a point along its normal, texels: on a surface that faces the light, and the addition on a grazing one.
// Higher values detach shadows from casters, lower ones give acne.
const float map_lift_facing = 1.0;
const float map_lift_grazing = 1.5;

// Returns 1 if light arrives, 0 behind an obstacle. `normal`: unit, to the lit side; `cosine`: between it and the
// light; `lower`: the light comes from the other end of the map.
float arriving(mat4 world_to_map, int layer, vec3 position, vec3 normal, float cosine, bool lower) {
  float slope = sqrt(max(1.0 - cosine * cosine, 0.0));
  vec3 lifted = position + normal * (shadow.x * (map_lift_facing + map_lift_grazing * slope));
  vec3 place = (world_to_map * vec4(lifted, 1.0)).xyz;
  float depth = clamp(lower ? 1.0 - place.z : place.z, 0.0, 1.0);
  return texture(light_maps, vec4(place.xy, float(layer), depth));
}

float key_arriving(vec3 position, vec3 normal) {
  return arriving(world_to_shadow, 0, position, normal, dot(normal, towards_key.xyz), false);
}

// Light of the sky on a surface, relative to an open side that faces straight up.
struct Sky {
  vec2 light;     // x: from the sky, y: reflected by the floor
  vec2 far_side;  // the same on the other side
  float open;     // visible fraction of all directions
};

// Returns 1 where the key light reaches the floor beyond a position, in a downward direction.
float floor_lit(vec3 position, vec3 downwards) {
  vec3 spot = position - downwards * ((position.y - ground.y) / min(downwards.y, -1e-4));
  return key_arriving(spot, vec3(0.0, 1.0, 0.0));
}

// Returns the light of the directions of a pass; the other side has the first pair alone. `floor_key`: 1 if the floor
// is shown, whose shadow then darkens what it reflects.
Sky sampled_sky(vec3 position, vec3 normal, float floor_key) {
  Sky sky = Sky(vec2(0.0), vec2(0.0), 0.0);
  for (int i = 0; i < sky_pairs; ++i) {
    vec3 upwards = towards_sky[i].xyz;
    float cosine = dot(normal, upwards);
    bool lower = cosine < 0.0;
    float weight = 2.0 * abs(cosine) / float(sky_pairs) *
                   arriving(world_to_sky[i], 2 * i + (lower ? 2 : 1), position, normal, cosine, lower);
    float reflected = 0.5 - 0.5 * key_share * floor_key * (1.0 - floor_lit(position, -upwards));
    sky.light += weight * (lower ? vec2(0.0, reflected) : vec2(1.0, 0.0));
    sky.open += weight;
  }
  float cosine = dot(normal, towards_sky[0].xyz);
  bool lower = cosine >= 0.0;
  sky.far_side = 2.0 * abs(cosine) * (lower ? vec2(0.0, 0.5) : vec2(1.0, 0.0)) *
                 arriving(world_to_sky[0], lower ? 2 : 1, position, -normal, cosine, lower);
  return sky;
}

// Returns the visible fraction of the sky from a spot of the floor.
float sampled_floor_openness(vec3 spot) {
  float open = 0.0;
  for (int i = 0; i < sky_pairs; ++i) {
    float cosine = towards_sky[i].y;
    open += cosine * arriving(world_to_sky[i], 2 * i + 1, spot, vec3(0.0, 1.0, 0.0), cosine, false);
  }
  return 2.0 * open / float(sky_pairs);
}
