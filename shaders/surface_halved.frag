#version 330 core
// Surfaces shaded for two by two pixels at a time, upscaled.
uniform ivec4 corner;      // xy: lower left corner of the tile in the framebuffer, px
uniform vec4 halved_part;  // xy: texture coordinates per drawn pixel
uniform usampler2D visibility_buffer;
uniform sampler2D halved;  // sRGB-encoded; transparent without a surface
layout(location = 0) out vec4 colour;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - corner.xy;
  if (texelFetch(visibility_buffer, pixel, 0).r == 0u) discard;
  // Only shaded samples count beside an outline; this pixel's own square was shaded.
  vec4 sum = textureLod(halved, (vec2(pixel) + 0.5) * halved_part.xy, 0.0);
  colour = vec4(sum.rgb / sum.a, 1.0);
}
