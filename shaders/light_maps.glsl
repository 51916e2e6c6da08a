// Depth maps of the lights, drawn by caster.vert: the key lamp has one layer; the sky has an upper and a lower layer for
// each pair of opposite directions.
uniform sampler2DArrayShadow key_map;
uniform sampler2DArrayShadow sky_maps;

// Motion of a point along its normal, texels: on a surface that faces the light, and the addition on a grazing one.
// Higher values detach shadows from casters, lower ones give acne.
const float lift_facing = 0.8;
const float lift_grazing = 1.7;
// Samples of a direction of the sky on a surface and on the floor, where one direction stands for a cone. Fewer show
// the edges of single shadows.
const int surface_taps = 5;
const int floor_taps = 32;
// Narrowest and widest blur of a direction's shadow on the floor, as fractions of the map's side.
const vec2 floor_blur_range = vec2(0.012, 0.45);

// Points evenly spread over the unit disc (Vogel 1979): each is the previous one turned by the golden angle and moved
// outwards. Turning a direction costs four multiplications; sines and cosines would dominate every loop.
const mat2 golden_turn = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888);
float disc_radius(int i, int count) { return sqrt((float(i) + 0.5) / float(count)); }

// Returns a position moved off its surface. `normal`: unit, to the lit side; `cosine`: between it and the light.
vec3 lifted(vec3 position, vec3 normal, float cosine, float texel_m) {
  float slope = sqrt(max(1.0 - cosine * cosine, 0.0));
  return position + normal * (texel_m * (lift_facing + lift_grazing * slope) + shadow_blur.w);
}

// Returns 1 where light of the key lamp's middle arrives, 0 behind an obstacle.
float key_arriving(vec3 position, vec3 normal) {
  vec3 spot = lifted(position, normal, dot(normal, towards_key.xyz), shadow.x);
  vec3 place = (world_to_shadow * vec4(spot, 1.0)).xyz;
  return texture(key_map, vec4(place.xy, 0.0, clamp(place.z, 0.0, 1.0)));
}

// Returns the fraction of a disc of the sky's map `layer` that no obstacle hides. `place`: as in world_to_sky, but depth
// grows away from the layer's light.
float open_share(vec3 place, int layer, float radius, int taps) {
  float open = 0.0;
  vec2 direction = vec2(1.0, 0.0);
  for (int i = 0; i < taps; ++i) {
    vec2 tap = place.xy + radius * disc_radius(i, taps) * direction;
    direction = golden_turn * direction;
    open += texture(sky_maps, vec4(tap, float(layer), clamp(place.z, 0.0, 1.0)));
  }
  return open / float(taps);
}

// Light of the sky on one side of a surface, relative to an open side that faces straight up.
struct Sky {
  vec2 light;  // x: from the sky, y: reflected by the floor
  float open;  // visible fraction of all directions
};

// Returns the light of an open sky, as in Sky.
vec2 open_light(float upwards) { return vec2(0.5 + 0.5 * upwards, 0.25 - 0.25 * upwards); }

// Returns the light of the first `pairs` pairs of directions of the maps, not occluded by anything in `all`.
Sky sky_light(vec3 position, vec3 normal, int pairs, out Sky all) {
  Sky sky = Sky(vec2(0.0), 0.0);
  all = sky;
  for (int i = 0; i < pairs; ++i) {
    vec3 upwards = towards_sky[i].xyz;
    float cosine = dot(normal, upwards);
    bool lower = cosine < 0.0;
    vec3 spot = lifted(position, normal, cosine, sky_maps_shape.y);
    vec3 place = (world_to_sky[i] * vec4(spot, 1.0)).xyz;
    place.z = lower ? 1.0 - place.z : place.z;
    float weight = 2.0 * abs(cosine) / float(pairs);
    int taps = sky_maps_shape.z > 0.0 ? surface_taps : 1;
    float arrived = weight * open_share(place, 2 * i + int(lower), sky_maps_shape.z, taps);
    // A floor that is shown is darker in its shadow. A software rasteriser skips loops but no branch.
    float reflected = 0.5;
    for (int k = 0; k < int(sky_floor.x); ++k) {
      vec3 below = position - upwards * ((position.y - ground.y) / max(upwards.y, 1e-4));
      reflected -= 0.5 * key_share * (1.0 - key_arriving(below, vec3(0.0, 1.0, 0.0)));
    }
    sky.light += arrived * (lower ? vec2(0.0, reflected) : vec2(1.0, 0.0));
    sky.open += arrived;
    all.light += weight * (lower ? vec2(0.0, 0.5) : vec2(1.0, 0.0));
    all.open += weight;
  }
  return sky;
}

// Returns the visible fraction of the sky from a spot of the floor.
float sky_over_floor(vec3 spot) {
  float open = 0.0;
  for (int i = 0; i < int(sky_maps_shape.x); ++i) {
    float cosine = towards_sky[i].y;
    vec3 place = (world_to_sky[i] * vec4(lifted(spot, vec3(0.0, 1.0, 0.0), cosine, sky_maps_shape.y), 1.0)).xyz;
    // The cone's blur assumes all casters in the middle of the map: a search for them would show as clouds.
    float radius = clamp(sky_maps_shape.w * (place.z - 0.5), floor_blur_range.x, floor_blur_range.y);
    bool blurred = sky_maps_shape.w > 0.0;
    open += cosine * open_share(place, 2 * i, blurred ? radius : 0.0, blurred ? floor_taps : 1);
  }
  return sky_maps_shape.x > 0.0 ? 2.0 * open / sky_maps_shape.x : 1.0;
}
