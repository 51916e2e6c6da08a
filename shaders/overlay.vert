#version 330 core
// Flat coloured triangles in pixels from the upper left corner.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texture_place;
layout(location = 2) in vec4 vertex_colour;
uniform vec4 pixels_to_clip;  // xy: scale, zw: offset
out vec2 place;
out vec4 shade;

void main() {
  place = texture_place;
  shade = vertex_colour;
  gl_Position = vec4(position * pixels_to_clip.xy + pixels_to_clip.zw, 0.0, 1.0);
}
