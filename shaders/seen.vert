#version 330 core
#include "frame.glsl"
#include "tables.glsl"
// Which triangle is seen where. Vertices are pulled from the tables, three for each triangle, so that a triangle's
// number needs no geometry stage.
flat out uint triangle;

void main() {
  triangle = uint(gl_VertexID) / 3u;
  uint corner = texelFetch(triangle_table, int(triangle))[gl_VertexID % 3];
  gl_Position = world_to_clip * vec4(texelFetch(vertex_table, int(3u * corner)).xyz, 1.0);
}
