// Base colour maps on surfaces, placed by corner coordinates.
uniform sampler2DArray base_colour_maps;  // one layer per map; linear, premultiplied

// Visible fraction of a map on the inside of the cloth.
const float shines_through = 0.3;
// Samples along the longer side of a pixel's footprint. Fewer blur maps seen at grazing angles.
const int most_taps = 4;

// Returns the colour; the arguments are the weights of the triangle's second and third corner, and their change per
// pixel.
vec4 base_colour(int triangle, vec2 share, vec2 share_across, vec2 share_up, float layer) {
  vec2 first = texelFetch(corner_data, texel(3 * triangle), 0).xy;
  mat2 sides = mat2(texelFetch(corner_data, texel(3 * triangle + 1), 0).xy - first, texelFetch(corner_data, texel(3 * triangle + 2), 0).xy - first);
  vec2 place = first + sides * share;
  vec2 size = vec2(textureSize(base_colour_maps, 0).xy);
  vec2 across = sides * share_across;
  vec2 up = sides * share_up;
  vec2 extents = vec2(length(across * size), length(up * size));
  vec2 longer = extents.x > extents.y ? across : up;
  float most = max(extents.x, extents.y);
  float least = max(min(extents.x, extents.y), 1e-6);
  float taps = clamp(ceil(most / least), 1.0, float(most_taps));
  float lod = log2(max(most / taps, least));
  vec4 sum = vec4(0.0);
  for (int i = 0; i < most_taps && float(i) < taps; ++i) {
    vec2 tap = place + longer * ((float(i) + 0.5) / taps - 0.5);
    sum += textureLod(base_colour_maps, vec3(tap.x, 1.0 - tap.y, layer), lod);
  }
  return sum / taps;
}
