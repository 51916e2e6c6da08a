#version 330 core
#include "frame.glsl"
#include "dither.glsl"
// Turns the sums of all passes into the finished picture.
uniform sampler2D drawn;   // surfaces: linear light before the film curve, and their coverage
uniform sampler2D behind;  // backdrop and floor as shown, linear; half as wide and high
uniform sampler2D marks;   // marks as shown, linear, premultiplied
uniform ivec4 corner;      // xy: lower left corner of the tile in the picture, px
uniform vec4 film;         // x: 1 / passes; y: 1 for data colours
layout(location = 0) out vec4 colour;  // sRGB-encoded

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - corner.xy;
  vec4 surfaces = film.x * texelFetch(drawn, pixel, 0);
  vec4 over = film.x * texelFetch(marks, pixel, 0);
  vec3 light = surfaces.rgb / max(surfaces.a, 1e-6);
  light = film.y > 0.5 ? tone_mapped(light) : filmed(light);
  vec4 sum = film.x * textureLod(behind, (vec2(pixel) + 0.5) * 0.5 / vec2(textureSize(behind, 0)), 0.0) * (1.0 - surfaces.a) + vec4(light, 1.0) * surfaces.a;
  sum = over + sum * (1.0 - over.a);
  colour = vec4(linear_to_srgb(sum.rgb) + dither() * step(sum.g, 0.998) * sum.a, sum.a);
}
