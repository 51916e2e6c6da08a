#version 330 core
uniform sampler2D backdrop_map;
uniform vec4 coarse;  // zw: texture coordinates for a drawn pixel
layout(location = 0) out vec4 colour;  // encoded

void main() { colour = vec4(textureLod(backdrop_map, gl_FragCoord.xy * coarse.zw, 0.0).rgb, 1.0); }
