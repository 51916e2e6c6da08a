// Cotton jersey as a change of brightness around 1. It is tied to the cloth's own material, and each part of it fades
// before a period gets shorter than two drawn pixels: there is nothing left to alias, and the mean stays as it was.
const float stitches_per_m = 620.0;   // of the knit: fine jersey
const float stitch_contrast = 0.11;
const float slub_contrast = 0.018;    // of uneven yarn, over a centimetre: what remains at figure scale

// A period of 1, mean 0, -1 to 1; a cosine without its cost.
vec3 wave(vec3 phase) {
  vec3 q = abs(2.0 * fract(phase) - 1.0);
  return 2.0 * q * q * (3.0 - 2.0 * q) - 1.0;
}

// 1 while a period covers four pixels, 0 from two downwards.
vec3 fade(vec3 phase_per_pixel) { return clamp(2.0 - 4.0 * phase_per_pixel, 0.0, 1.0); }

// One plane's stitches: columns, and rows between them.
float stitches(float column, float crossed, float row) { return 0.6 * column + 0.4 * crossed * row; }

// `across`, `up`: how the material moves from pixel to pixel.
float weave_brightness(vec3 material, vec3 across, vec3 up, float strength) {
  vec3 extent = abs(across) + abs(up);
  // Three planes, each where the material faces it: jersey has no direction that a garment's rest shape would tell.
  vec3 facing = cross(across, up);
  vec3 share = facing * facing / max(dot(facing, facing), 1e-30);
  vec3 thread_share = fade(stitches_per_m * extent);
  float knit = 0.0;
  // A loop, because a software rasteriser ends one early and skips no branch.
  bool threads_show = max(thread_share.x, max(thread_share.y, thread_share.z)) > 0.0;
  for (int i = 0; i < (threads_show ? 1 : 0); ++i) {
    vec3 thread = thread_share * wave(stitches_per_m * material);
    vec3 half_thread = thread_share * wave(stitches_per_m * material + 0.5);
    knit = share.z * stitches(thread.x, half_thread.x, thread.y) +
           share.x * stitches(thread.z, half_thread.z, thread.y) +
           share.y * stitches(thread.x, half_thread.x, thread.z);
  }
  // Directions and lengths without a common measure, so that no pattern is seen to repeat.
  const mat3 first = mat3(61.0, 97.0, -43.0, 89.0, -37.0, 71.0, -53.0, 47.0, 101.0);
  const mat3 second = mat3(-83.0, 59.0, 107.0, 67.0, 103.0, 29.0, 41.0, -79.0, 73.0);
  vec3 slubs = wave(first * material) * wave(second * material) *
               fade(abs(first * across) + abs(first * up)) * fade(abs(second * across) + abs(second * up));
  return 1.0 + strength * (stitch_contrast * knit + slub_contrast * dot(slubs, vec3(1.0)));
}
