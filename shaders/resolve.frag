#version 330 core
#include "frame.glsl"
// Averages samples and supersampled pixels in linear light, lays them over what is behind, and encodes.
uniform ivec4 resolve;  // x: samples, y: supersampling, zw: where the tile starts in the picture, px
#ifdef MULTISAMPLED
uniform sampler2DMS drawn;
#else
uniform sampler2D drawn;
#endif
uniform sampler2D behind;  // the picture's tile
layout(location = 0) out vec4 colour;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - resolve.zw;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < resolve.y; ++y) {
    for (int x = 0; x < resolve.y; ++x) {
      ivec2 source = pixel * resolve.y + ivec2(x, y);
#ifdef MULTISAMPLED
      for (int i = 0; i < resolve.x; ++i) sum += texelFetch(drawn, source, i);
#else
      sum += texelFetch(drawn, source, 0);
#endif
    }
  }
  sum /= float(resolve.x * resolve.y * resolve.y);
  vec3 light = sum.rgb + (1.0 - sum.a) * texelFetch(behind, pixel, 0).rgb;
  colour = vec4(linear_to_srgb_fast(light), 1.0);
}
