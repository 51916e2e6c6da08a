#version 330 core
#include "frame.glsl"
#include "backdrop.glsl"
#include "floor.glsl"
// Backdrop and floor, in the key light and in its shadow, at the corners of a grid over the tile. They vary slowly, and
// a software rasteriser interpolates colours faster than it samples them. One instance per row. Shadows fade towards
// the lower edge and the sides of the picture, so that none is cut; the margin is a fraction of its height.
const float shadow_fade = 0.14;
uniform vec4 grid;  // xy: columns and rows, z: 1 with a floor
noperspective out vec3 in_light;   // sRGB-encoded
noperspective out vec3 in_shadow;  // sRGB-encoded

void main() {
  vec2 corner = vec2(float(gl_VertexID >> 1), float(gl_InstanceID + (gl_VertexID & 1))) / grid.xy;
  vec3 direction = normalize(ray_through(corner * viewport.xy));
  vec3 spot = eye.xyz + direction * ((ground.y - eye.y) / min(direction.y, -1e-6));
  bool floor_seen = grid.z > 0.5 && direction.y < 0.0;
  vec3 behind = backdrop_colour(direction);
  in_light = linear_to_srgb(floor_seen ? floor_colour(spot, direction, 1.0) : behind);
  vec2 in_picture = corner * viewport.xy + vec2(ray_corner.w, ray_up.w);
  float from_edge = min(in_picture.y, min(in_picture.x, ray_across.w - in_picture.x)) / viewport.w;
  float faded = 1.0 - smoothstep(0.0, shadow_fade, from_edge);
  in_shadow = linear_to_srgb(floor_seen ? floor_colour(spot, direction, faded) : behind);
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
