#version 330 core
uniform sampler2D coverage;  // one channel: how much of each pixel a letter covers
in vec2 place;
in vec4 shade;
layout(location = 0) out vec4 colour;

void main() {
  colour = vec4(shade.rgb, shade.a * texture(coverage, place).r);
}
