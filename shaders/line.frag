#version 330 core
uniform vec4 mark;
in vec3 line_colour;
in float across_px;
flat in float half_width_px;
layout(location = 0) out vec4 colour;

void main() {
  // Fraction of a pixel-wide window that the line covers: lines thinner than a pixel are fainter, not broken.
  float coverage = clamp(half_width_px + 0.5 - abs(across_px), 0.0, min(1.0, 2.0 * half_width_px));
  colour = vec4(line_colour, mark.y * coverage);
}
