#version 330 core
// Surfaces shaded for two by two pixels at a time, upscaled; with several samples, blended by their share of the pixel.
uniform ivec4 corner;      // xy: lower left corner of the tile in the framebuffer, px
uniform vec4 halved_part;  // xy: texture coordinates per drawn pixel
#ifdef MULTISAMPLED
uniform usampler2DMS visibility_buffer;  // four samples
#else
uniform usampler2D visibility_buffer;
#endif
uniform sampler2D halved;  // sRGB-encoded; transparent without a surface
layout(location = 0) out vec4 colour;  // sRGB-encoded, premultiplied

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - corner.xy;
#ifdef MULTISAMPLED
  float covered = 0.0;
  for (int i = 0; i < 4; ++i) covered += texelFetch(visibility_buffer, pixel, i).r == 0u ? 0.0 : 0.25;
#else
  float covered = texelFetch(visibility_buffer, pixel, 0).r == 0u ? 0.0 : 1.0;
#endif
  if (covered == 0.0) discard;
  // Only shaded samples count beside an outline; this pixel's own square was shaded.
  vec4 sum = textureLod(halved, (vec2(pixel) + 0.5) * halved_part.xy, 0.0);
  colour = covered * vec4(sum.rgb / sum.a, 1.0);
}
