#version 330 core
#include "frame.glsl"
#include "dither.glsl"
noperspective in vec3 in_light;
#ifdef SHADED
noperspective in vec3 in_shadow;
uniform sampler2D floor_shadow;
uniform vec4 shaded_part;  // texture coordinates of the floor's shadow: xy: scale per drawn pixel, zw: offset
#endif
layout(location = 0) out vec4 colour;  // sRGB-encoded

void main() {
  vec3 seen = in_light;
#ifdef SHADED
  // Each bilinear sample averages neighbours; half a texel apart, all four directions of sampling count alike.
  vec2 place = gl_FragCoord.xy * shaded_part.xy + shaded_part.zw;
  vec2 near = 0.5 / vec2(textureSize(floor_shadow, 0));
  float lit = 0.25 * (textureLod(floor_shadow, place + near, 0.0).r + textureLod(floor_shadow, place - near, 0.0).r +
                      textureLod(floor_shadow, place + vec2(near.x, -near.y), 0.0).r +
                      textureLod(floor_shadow, place + vec2(-near.x, near.y), 0.0).r);
  // Mixing needs linear light; squares approximate it.
  seen = sqrt(mix(in_shadow * in_shadow, seen * seen, lit));
#endif
  seen += dither() * step(seen.g, 0.999);
  colour = backdrop_horizon.z > 0.5 ? vec4(vec3(0.0), 1.0 - seen.g) : vec4(seen, 1.0);
}
