// Light from the whole studio around: bright from above, weaker from below, reduced by what stands in the way. Each
// direction has a small depth map in one atlas.
const int max_sky_directions = 64;
layout(std140) uniform Sky {
  vec4 sky_info;                               // x: number of directions; y: columns; z: rows; w: lift, m
  vec4 sky_directions[max_sky_directions];     // xyz: unit, towards the light; w: its brightness
  mat4 world_to_sky[max_sky_directions];       // to 0..1 within the direction's own map
};
uniform sampler2DShadow sky_atlas;

float sky_visibility(int i, vec3 position) {
  vec3 place = (world_to_sky[i] * vec4(position, 1.0)).xyz;
  vec2 cells = sky_info.yz;
  vec2 cell = vec2(mod(float(i), cells.x), floor(float(i) / cells.x));
  // Filtering must not reach into the neighbouring map.
  vec2 inside = clamp(place.xy, 0.004, 0.996);
  return textureLod(sky_atlas, vec3((cell + inside) / cells, min(place.z, 1.0)), 0.0);
}

// An open studio, for when no directions are tested: the same integral without anything in the way.
float open_sky(vec3 normal) { return mix(0.5, 1.0, 0.5 + 0.5 * normal.y); }
