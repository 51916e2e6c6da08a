#version 330 core
#include "frame.glsl"
// One instance per segment, drawn as a strip of two triangles.
layout(location = 0) in vec3 start;
layout(location = 1) in vec3 end;
layout(location = 2) in vec3 start_colour;
layout(location = 3) in vec3 end_colour;
uniform vec4 mark;  // x: width, picture pixels; y: opacity; z: lift towards the eye, fraction of the distance
out vec3 line_colour;
out float across_px;
flat out float half_width_px;

// Segments are clipped at the near plane, as points behind the eye cannot be projected.
vec4 cut(vec4 from, vec4 to) {
  const float nearest = 1e-3;
  return from.w >= nearest ? from : mix(from, to, clamp((nearest - from.w) / (to.w - from.w), 0.0, 1.0));
}

void main() {
  vec4 a = world_to_clip * vec4(mix(start, eye.xyz, mark.z), 1.0);
  vec4 b = world_to_clip * vec4(mix(end, eye.xyz, mark.z), 1.0);
  if (a.w < 1e-3 && b.w < 1e-3) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec4 cut_a = cut(a, b);
  vec4 cut_b = cut(b, a);
  bool at_end = (gl_VertexID & 1) == 1;
  vec4 clip = at_end ? cut_b : cut_a;
  vec2 direction = (cut_b.xy / cut_b.w - cut_a.xy / cut_a.w) * viewport.xy;
  float length_px = length(direction);
  direction = length_px > 1e-6 ? direction / length_px : vec2(1.0, 0.0);
  half_width_px = 0.5 * mark.x * viewport.z;
  // One pixel more on each side carries the soft edge.
  across_px = (gl_VertexID < 2 ? -1.0 : 1.0) * (half_width_px + 1.0);
  clip.xy += vec2(-direction.y, direction.x) * across_px * 2.0 / viewport.xy * clip.w;
  line_colour = srgb_to_linear(at_end ? end_colour : start_colour);
  gl_Position = clip;
}
