#version 330 core
// Averages samples and supersampled pixels in linear light.
uniform ivec4 resolve;  // x: samples, y: supersampling, zw: lower left corner of the tile in the picture, px
#ifdef MULTISAMPLED
uniform sampler2DMS drawn;
#else
uniform sampler2D drawn;
#endif
layout(location = 0) out vec4 colour;  // linear, premultiplied

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
  colour = sum / float(resolve.x * resolve.y * resolve.y);
}
