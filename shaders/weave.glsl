// Threads of cloth: they vary its brightness around 1 and mix in the colour of its other side. They are fixed in the
// cloth's material. Each detail fades before its period gets shorter than two drawn pixels, so that nothing aliases and
// the mean stays.
const float thread_contrast = 0.26;
const float thread_relief = 0.32;
// Arrays below are in the order of WeaveKind: knit, plain, twill, satin.
const int satin_kind = 3;
// Weights of a period's details: threads of the warp, of the weft, and their crossings.
const vec3 parts[4] = vec3[4](vec3(0.5, 0.5, 0.0), vec3(0.3, 0.3, 0.4), vec3(0.25, 0.1, 0.0), vec3(0.5, 0.0, 0.0));
// Diagonal lines: their frequency per thread of the warp and the weft, and their weight.
const vec3 lines[4] = vec3[4](vec3(0.0), vec3(0.0), vec3(0.25, -0.25, 0.75), vec3(0.4, 0.2, 0.5));
// Rows of a knit per column, and the lean of the two legs of a stitch.
const vec2 rows[4] = vec2[4](vec2(1.3, 0.8), vec2(1.0, 0.0), vec2(1.0, 0.0), vec2(1.0, 0.0));
// Amplitude of the other side's colour along the lines.
const float dyed[4] = float[4](0.0, 0.0, 0.16, 0.0);
// Width and length, m, over which fine and coarse yarn stays the same; weights of yarn along warp and weft.
const vec4 yarn = vec4(0.0012, 0.014, 0.005, 0.045);
const vec2 runs[4] = vec2[4](vec2(0.15, 0.85), vec2(0.5, 0.5), vec2(0.8, 0.2), vec2(0.7, 0.3));
const float yarn_contrast = 0.4;
// Lengths, m, of dents that handled cloth keeps, and their slope for an unevenness of 1. The slope grows with the root
// of the unevenness.
const vec2 dents = vec2(0.017, 0.0052);
const float dent_slope = 0.055;

struct Weave {
  float brightness;
  float other_side;  // fraction of its colour; below 0 where it is less than elsewhere
  vec2 slope;        // of dents, along weft and warp
};

// Returns a cheap cosine of period 1, -1 to 1, with mean 0.
vec4 wave(vec4 phase) {
  vec4 q = abs(2.0 * fract(phase) - 1.0);
  return 2.0 * q * q * (3.0 - 2.0 * q) - 1.0;
}

// Returns 1 while a period covers at least four pixels, 0 from two downwards.
vec4 fade(vec4 phase_per_pixel) { return clamp(2.0 - 4.0 * phase_per_pixel, 0.0, 1.0); }

// Returns one plane's threads: x: height, y: lines; both -1 to 1. `place`: in threads, x across the warp, y along it;
// `extent`: threads per pixel.
vec2 threads(int kind, vec2 place, vec2 extent) {
  // Legs of stitches are half as wide as a column.
  float leg = abs(2.0 * fract(place.x) - 1.0);
  place.y = rows[kind].x * place.y + rows[kind].y * leg;
  extent.y = rows[kind].x * extent.y + 2.0 * rows[kind].y * extent.x;
  vec3 line = lines[kind];
  vec4 shown = fade(vec4(extent, dot(abs(line.xy), extent), 1.0)) * wave(vec4(place, dot(line.xy, place), 0.0));
  vec4 over = fade(vec4(0.5 * extent, 1.0, 1.0)) * wave(vec4(0.5 * place, 0.0, 0.0));
  float along = line.z * shown.z;
  return vec2(dot(parts[kind], vec3(shown.xy, over.x * over.y)) + along, along);
}

// Returns a pseudo-random number, -1 to 1.
float scattered(ivec2 cell) {
  uint h = uint(cell.x) * 0x9E3779B1u ^ uint(cell.y) * 0x85EBCA77u;
  h = (h ^ (h >> 15u)) * 0x2C1B3C6Du;
  return float((h ^ (h >> 13u)) & 0xFFFFu) / 32767.5 - 1.0;
}

// Returns smooth noise, -1 to 1, in x, and its slope in y and z.
vec3 uneven(vec2 place) {
  ivec2 cell = ivec2(floor(place));
  vec2 part = fract(place);
  vec2 rate = 6.0 * part * (1.0 - part);
  part *= part * (3.0 - 2.0 * part);
  vec4 at = vec4(scattered(cell), scattered(cell + ivec2(1, 0)), scattered(cell + ivec2(0, 1)),
                 scattered(cell + ivec2(1, 1)));
  vec2 row = mix(at.xz, at.yw, part.x);
  return vec3(mix(row.x, row.y, part.y), rate.x * mix(at.y - at.x, at.w - at.z, part.y), rate.y * (row.y - row.x));
}

// Returns the slope of dents. Lengths in m.
vec2 dented(vec2 place, vec2 extent) {
  const mat2 turn = mat2(0.8, 0.6, -0.6, 0.8);  // the lattices of noise lie askew, so that none shows
  vec2 shown = fade(max(extent.x, extent.y) / dents.xyxy).xy;
  return shown.x * uneven(turn * place / dents.x).yz * turn +
         shown.y * uneven(place * turn / dents.y + 5.0).yz * transpose(turn);
}

// Returns the variation between yarns, -1 to 1. Lengths in m.
float yarns(int kind, vec2 place, vec2 extent) {
  vec4 shown = fade(vec4(extent / yarn.x, extent / yarn.z));
  float sum = 0.0;
  // A software rasteriser ends loops early: fine yarns are skipped from afar.
  for (int i = shown.x + shown.y > 0.0 ? 0 : 1; i < (shown.z + shown.w > 0.0 ? 2 : 0); ++i) {
    vec2 size = i == 0 ? yarn.xy : yarn.zw;
    vec2 share = runs[kind] * (i == 0 ? shown.xy : 0.5 * shown.zw);
    sum += share.x * uneven(place / size + 0.5).x + share.y * uneven(place.yx / size + 7.0).x;
  }
  return sum;
}

// Returns the weave. `across`, `up`: change of the material coordinate per pixel; `towards_key`: direction of the key
// light along weft and warp; `count`: threads per metre.
Weave weave_at(vec3 material, vec3 across, vec3 up, vec2 towards_key, int kind, float strength, float count,
               float unevenness) {
  // Three planes are blended by how much the material faces them, as a garment's rest shape does not tell how its cloth
  // was cut.
  vec3 facing = abs(cross(across, up));
  vec3 share = max(facing - 0.4 * max(facing.x, max(facing.y, facing.z)), 0.0);
  share /= max(share.x + share.y + share.z, 1e-30);
  mat3x2 places = mat3x2(material.zy, material.xz, material.xy);
  vec3 extent = abs(across) + abs(up);
  mat3x2 extents = mat3x2(extent.zy, extent.xz, extent.xy);
  Weave weave = Weave(1.0, 0.0, vec2(0.0));
  // A software rasteriser ends loops early but skips no branch: most places face one plane.
  for (int left = 3; left > 0 && share.x + share.y + share.z > 0.01; --left) {
    int plane = share.z > 0.01 ? 2 : share.x > 0.01 ? 0 : 1;
    vec2 place = places[plane];
    vec2 wide = extents[plane];
    float part = share[plane];
    share[plane] = 0.0;
    weave.brightness += part * unevenness * yarn_contrast * yarns(kind, place, wide);
    weave.slope += part * sqrt(unevenness) * dent_slope * dented(place, wide);
    for (int i = 0; i < (count * min(wide.x, wide.y) < (kind == 0 ? 0.5 : 2.0) ? 1 : 0); ++i) {
      vec2 height = threads(kind, count * place, count * wide);
      float lower = threads(kind, count * place + 0.25 * towards_key, count * wide).x;
      weave.brightness += part * strength * (thread_contrast * height.x + thread_relief * (height.x - lower));
      weave.other_side += part * strength * dyed[kind] * height.y;
    }
  }
  return weave;
}
