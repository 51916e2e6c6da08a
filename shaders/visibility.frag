#version 330 core
flat in uint triangle;
layout(location = 0) out uint visible;  // see surface_buffers.glsl

void main() { visible = 2u * triangle + (gl_FrontFacing ? 3u : 2u); }
