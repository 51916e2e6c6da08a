#version 330 core
// Surfaces shaded for two by two pixels at a time, upscaled. Outlines are smooth: the pixels around one share it.
uniform ivec4 corner;      // xy: lower left corner of the tile in the framebuffer, px
uniform vec4 halved_part;  // xy: texture coordinates per drawn pixel
uniform usampler2D visibility_buffer;
uniform sampler2D halved;  // sRGB-encoded; transparent without a surface, opaque away from outlines
layout(location = 0) out vec4 colour;  // sRGB-encoded, premultiplied

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - corner.xy;
  // Only shaded samples count beside an outline.
  vec4 sum = textureLod(halved, (vec2(pixel) + 0.5) * halved_part.xy, 0.0);
  if (sum.a == 0.0) discard;
  bool whole = sum.a > 0.999;
  float covered = whole ? 1.0 : 0.0;
  ivec2 last = textureSize(visibility_buffer, 0) - 1;
  // A loop instead of a branch, as in weave.glsl: a tent over three by three pixels.
  for (int i = 0; i < (whole || sum.a == 0.0 ? 0 : 9); ++i) {
    ivec2 step = ivec2(i % 3, i / 3) - 1;
    bool seen = texelFetch(visibility_buffer, clamp(pixel + step, ivec2(0), last), 0).r != 0u;
    covered += seen ? 0.25 / float((1 + abs(step.x)) * (1 + abs(step.y))) : 0.0;
  }
  if (covered == 0.0) discard;
  colour = covered * vec4(sum.rgb / sum.a, 1.0);
}
