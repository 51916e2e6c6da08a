// Returns up to half a step of eight bits, in a pattern of four by four pixels (Bayer 1973): without it slow gradients
// show bands. A repeating pattern compresses better than noise.
float dither() {
  ivec2 place = ivec2(gl_FragCoord.xy) & 3;
  int mixed = place.x ^ place.y;
  int rank = 8 * (mixed & 1) + 4 * (place.y & 1) + (mixed & 2) + (place.y >> 1);
  return (float(rank) - 7.5) / (16.0 * 255.0);
}
