#version 330 core
uniform sampler2D backdrop_lit;
#ifdef SHADED
uniform sampler2D backdrop_dark;
uniform sampler2D floor_shadow;
uniform vec4 shaded_part;  // texture coordinates of the floor's shadow: xy: scale for a drawn pixel, zw: offset
#endif
uniform vec4 coarse;  // zw: texture coordinates for a drawn pixel
layout(location = 0) out vec4 colour;  // encoded

void main() {
  vec2 place = gl_FragCoord.xy * coarse.zw;
  vec3 seen = textureLod(backdrop_lit, place, 0.0).rgb;
#ifdef SHADED
  float lit = textureLod(floor_shadow, gl_FragCoord.xy * shaded_part.xy + shaded_part.zw, 0.0).r;
  vec3 dark = textureLod(backdrop_dark, place, 0.0).rgb;
  // Light adds up in linear light, for which squares do.
  seen = sqrt(mix(dark * dark, seen * seen, lit));
#endif
  colour = vec4(seen, 1.0);
}
