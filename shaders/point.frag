#version 330 core
#include "frame.glsl"
uniform vec4 mark;
in vec3 disc_colour;
in vec2 from_centre_px;
layout(location = 0) out vec4 colour;

void main() {
  float coverage = clamp(0.5 * mark.x * viewport.z + 0.5 - length(from_centre_px), 0.0, 1.0);
  colour = vec4(disc_colour, mark.y * coverage);
}
