// How the threads of cloth change its brightness around 1, and mix in the colour of its other side. They are tied to
// the cloth's own material, and each part of them fades before a period gets shorter than two drawn pixels: there is
// nothing left to alias, and the mean stays as it was.
const float thread_contrast = 0.11;
const float slub_contrast = 0.018;  // of uneven yarn, over a centimetre: what remains at figure scale
// In the order of WeaveKind: knit, plain, twill, satin.
const int satin_kind = 3;
// Shares of what one sees of a period: columns, rows, rows of stitches between columns, squares over and under.
const vec4 parts[4] = vec4[4](vec4(0.6, 0.0, 0.4, 0.0), vec4(0.3, 0.3, 0.0, 0.4), vec4(0.25, 0.0, 0.0, 0.0),
                              vec4(0.5, 0.0, 0.0, 0.0));
// Lines across both: threads of the warp and the weft in a period of them, and their share.
const vec3 lines[4] = vec3[4](vec3(0.0), vec3(0.0), vec3(0.25, -0.25, 0.75), vec3(0.4, 0.2, 0.5));
// How far yarn keeps its thickness along the warp, as a share of across it, and how much it differs.
const vec2 slub[4] = vec2[4](vec2(1.0), vec2(0.35, 0.8), vec2(0.1, 2.6), vec2(0.2, 0.7));
// How much of the other side's colour comes and goes with the lines.
const float dyed[4] = float[4](0.0, 0.0, 0.12, 0.0);

struct Weave {
  float brightness;
  float other_side;  // share of its colour; below 0 where there is less of it than elsewhere
};

// A period of 1, mean 0, -1 to 1; a cosine without its cost.
vec4 wave(vec4 phase) {
  vec4 q = abs(2.0 * fract(phase) - 1.0);
  return 2.0 * q * q * (3.0 - 2.0 * q) - 1.0;
}

// 1 while a period covers four pixels, 0 from two downwards.
vec4 fade(vec4 phase_per_pixel) { return clamp(2.0 - 4.0 * phase_per_pixel, 0.0, 1.0); }

// One plane's threads. `place`: in threads, x across the warp, y along it; `extent`: how many of them a pixel covers.
// x: brightness, y: lines; both -1 to 1.
vec2 threads(int kind, vec2 place, vec2 extent) {
  vec4 single = fade(extent.xyxy) * wave(vec4(place, place.x + 0.5, 0.0));
  vec3 line = lines[kind];
  vec4 wide = fade(vec4(0.5 * extent, dot(abs(line.xy), extent), 1.0)) * wave(vec4(0.5 * place, dot(line.xy, place), 0.0));
  float along = line.z * wide.z;
  return vec2(dot(parts[kind], vec4(single.x, single.y, single.z * single.y, wide.x * wide.y)) + along, along);
}

// `across`, `up`: how the material moves from pixel to pixel.
Weave weave_at(vec3 material, vec3 across, vec3 up, float strength, int kind, float threads_per_m) {
  vec3 extent = abs(across) + abs(up);
  // Three planes, each where the material faces it: a garment's rest shape does not tell how its cloth was cut.
  vec3 facing = cross(across, up);
  vec3 share = facing * facing / max(dot(facing, facing), 1e-30);
  vec3 counted = threads_per_m * extent;
  vec2 seen = vec2(0.0);
  // A loop, because a software rasteriser ends one early and skips no branch.
  bool threads_show = min(counted.x, min(counted.y, counted.z)) < (kind == 0 ? 0.5 : 2.0);
  for (int i = 0; i < (threads_show ? 1 : 0); ++i) {
    vec3 place = threads_per_m * material;
    seen = share.z * threads(kind, place.xy, counted.xy) + share.x * threads(kind, place.zy, counted.zy) +
           share.y * threads(kind, place.xz, counted.xz);
  }
  // Directions and lengths without a common measure, so that no pattern is seen to repeat.
  const mat3 first = mat3(61.0, 97.0, -43.0, 89.0, -37.0, 71.0, -53.0, 47.0, 101.0);
  const mat3 second = mat3(-83.0, 59.0, 107.0, 67.0, 103.0, 29.0, 41.0, -79.0, 73.0);
  vec3 along = vec3(1.0, slub[kind].x, 1.0);
  material *= along;
  across *= along;
  up *= along;
  vec3 slubs = wave(vec4(first * material, 0.0)).xyz * wave(vec4(second * material, 0.0)).xyz *
               fade(vec4(abs(first * across) + abs(first * up), 0.0)).xyz *
               fade(vec4(abs(second * across) + abs(second * up), 0.0)).xyz;
  return Weave(1.0 + strength * (thread_contrast * seen.x + slub_contrast * slub[kind].y * dot(slubs, vec3(1.0))),
               strength * dyed[kind] * seen.y);
}
