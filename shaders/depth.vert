#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 world_to_map;

void main() { gl_Position = world_to_map * vec4(position, 1.0); }
