#version 330 core
noperspective in vec3 in_light;
#ifdef SHADED
noperspective in vec3 in_shadow;
uniform sampler2D floor_shadow;
uniform vec4 shaded_part;  // texture coordinates of the floor's shadow: xy: scale for a drawn pixel, zw: offset
#endif
layout(location = 0) out vec4 colour;  // encoded

void main() {
  vec3 seen = in_light;
#ifdef SHADED
  float lit = textureLod(floor_shadow, gl_FragCoord.xy * shaded_part.xy + shaded_part.zw, 0.0).r;
  // Light adds up in linear light, for which squares do.
  seen = sqrt(mix(in_shadow * in_shadow, seen * seen, lit));
#endif
  colour = vec4(seen, 1.0);
}
