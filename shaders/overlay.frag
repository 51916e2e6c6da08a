#version 330 core
uniform sampler2D sheet;  // white letters and small pictures
in vec2 place;
in vec4 shade;
layout(location = 0) out vec4 colour;

void main() {
  colour = shade * texture(sheet, place);
}
