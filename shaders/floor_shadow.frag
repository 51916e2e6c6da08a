#version 330 core
#include "frame.glsl"
#include "shadow.glsl"
// Fraction of the key light that reaches the floor, for two by two drawn pixels at a time: casters are far enough away
// for no sharper edge, and backdrop.frag interpolates.
uniform vec4 coarse;  // xy: drawn pixels left of and below the drawn part, z: drawn pixels per pixel here
layout(location = 0) out float lit;

void main() {
  vec3 ray = ray_through(coarse.xy + coarse.z * gl_FragCoord.xy);
  vec3 spot = eye.xyz + ray * ((ground.y - eye.y) / min(ray.y, -1e-6));
  lit = key_visibility(spot, vec3(0.0, 1.0, 0.0), ray.y < 0.0);
}
