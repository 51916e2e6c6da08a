#version 330 core
flat in uint triangle;
layout(location = 0) out uint seen;  // as tables.glsl has it

void main() { seen = 2u * triangle + (gl_FrontFacing ? 3u : 2u); }
