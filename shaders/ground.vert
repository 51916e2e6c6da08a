#version 330 core
#include "frame.glsl"
out vec3 world;

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  world = vec3(ground.x + corner.x * ground.w, ground.y, ground.z + corner.y * ground.w);
  gl_Position = world_to_clip * vec4(world, 1.0);
}
