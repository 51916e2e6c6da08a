#version 330 core
#include "frame.glsl"
// Averages samples and supersampled pixels in linear light, encodes, and turns the picture upside down if asked.
uniform ivec4 resolve;  // x: samples, y: supersampling, z: height of the tile, px; w: 1 to have the top row first
uniform ivec4 corner;   // xy: where the tile starts in the target, px
#ifdef MULTISAMPLED
uniform sampler2DMS drawn;
#else
uniform sampler2D drawn;
#endif
layout(location = 0) out vec4 colour;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - corner.xy;
  if (resolve.w == 1) pixel.y = resolve.z - 1 - pixel.y;
  vec3 sum = vec3(0.0);
  for (int y = 0; y < resolve.y; ++y) {
    for (int x = 0; x < resolve.y; ++x) {
      ivec2 source = pixel * resolve.y + ivec2(x, y);
#ifdef MULTISAMPLED
      for (int i = 0; i < resolve.x; ++i) sum += texelFetch(drawn, source, i).rgb;
#else
      sum += texelFetch(drawn, source, 0).rgb;
#endif
    }
  }
  colour = vec4(linear_to_srgb(sum / float(resolve.x * resolve.y * resolve.y)), 1.0);
}
