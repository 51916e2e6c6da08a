#version 330 core
layout(location = 0) in vec2 corner_in_clip;

void main() { gl_Position = vec4(corner_in_clip, 0.0, 1.0); }
