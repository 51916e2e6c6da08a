#version 330 core
#include "frame.glsl"
layout(location = 0) in vec3 centre;
layout(location = 1) in vec3 point_colour;
uniform vec4 mark;  // x: diameter, picture pixels; y: opacity; z: lift towards the eye, fraction of the distance
out vec3 disc_colour;
out vec2 from_centre_px;

void main() {
  vec4 clip = world_to_clip * vec4(mix(centre, eye.xyz, mark.z), 1.0);
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  from_centre_px = corner * (0.5 * mark.x * viewport.z + 1.0);
  clip.xy += from_centre_px * 2.0 / viewport.xy * clip.w;
  disc_colour = srgb_to_linear(point_colour);
  gl_Position = clip;
}
