#version 330 core
#include "frame.glsl"
#include "backdrop.glsl"
#include "floor.glsl"
// Backdrop and floor, in the key light and in its shadow, at the corners of a grid over the tile. They vary slowly, and
// a software rasteriser interpolates colours faster than it samples them. One instance per row.
uniform vec4 grid;  // xy: columns and rows, z: 1 with a floor
noperspective out vec3 in_light;   // sRGB-encoded
noperspective out vec3 in_shadow;  // sRGB-encoded

void main() {
  vec2 corner = vec2(float(gl_VertexID >> 1), float(gl_InstanceID + (gl_VertexID & 1))) / grid.xy;
  vec3 direction = normalize(ray_through(corner * viewport.xy));
  vec3 spot = eye.xyz + direction * ((ground.y - eye.y) / min(direction.y, -1e-6));
  bool floor_seen = grid.z > 0.5 && direction.y < 0.0;
  vec3 behind = backdrop_colour(direction);
  float open = floor_openness(spot);
  in_light = linear_to_srgb(floor_seen ? floor_colour(spot, direction, 1.0, open) : behind);
  float faded = shadow_fading(corner * viewport.xy);
  in_shadow = linear_to_srgb(floor_seen ? floor_colour(spot, direction, faded, open) : behind);
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
