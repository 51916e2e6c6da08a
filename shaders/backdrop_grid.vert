#version 330 core
#include "frame.glsl"
#include "backdrop.glsl"
#include "floor.glsl"
// Backdrop and floor, in the key light and in its shadow, at the corners of a grid over the tile. Nothing there changes
// from pixel to pixel, and a software rasteriser blends colours faster than it looks them up. One instance a row.
uniform vec4 grid;  // xy: columns and rows, z: 1 with a floor
noperspective out vec3 in_light;   // encoded
noperspective out vec3 in_shadow;  // encoded

void main() {
  vec2 corner = vec2(float(gl_VertexID >> 1), float(gl_InstanceID + (gl_VertexID & 1))) / grid.xy;
  vec3 direction = normalize(ray_through(corner * viewport.xy));
  vec3 spot = eye.xyz + direction * ((ground.y - eye.y) / min(direction.y, -1e-6));
  bool floor_seen = grid.z > 0.5 && direction.y < 0.0;
  vec3 behind = backdrop_colour(direction);
  in_light = linear_to_srgb(floor_seen ? floor_colour(spot, direction, 1.0) : behind);
  in_shadow = linear_to_srgb(floor_seen ? floor_colour(spot, direction, 0.0) : behind);
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
