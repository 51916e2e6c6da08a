#version 330 core
#include "frame.glsl"
// Draws triangle numbers.
layout(location = 0) in vec3 position;  // m; three per triangle, so that its number needs no geometry stage
flat out uint triangle;

void main() {
  triangle = uint(gl_VertexID) / 3u;
  gl_Position = world_to_clip * vec4(position, 1.0);
}
