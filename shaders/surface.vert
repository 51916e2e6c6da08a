#version 330 core
#include "frame.glsl"
#include "sky.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float scalar;  // 0..1, below 0 for not a number
layout(location = 4) in vec3 material_coordinate;  // m
layout(location = 3) in float decided;  // of the key light: 1 in it, 0 in its shadow, 0.5 for pixels to find out
centroid out vec3 world;
centroid out vec3 world_normal;
centroid out float shown_scalar;
centroid out vec2 sky_light;  // x: outside, y: inside
centroid out float decided_shadow;
out vec3 material;

void main() {
  world = position;
  world_normal = normal;
  shown_scalar = scalar;
  decided_shadow = decided;
  material = material_coordinate;
  sky_light = vec2(open_sky(normal), open_sky(-normal));
  if (sky_info.x > 0.0) {
    vec2 sum = vec2(0.0);
    for (int i = 0; i < int(sky_info.x); ++i) {
      float cosine = dot(normal, sky_directions[i].xyz);
      // Each direction lights one side, and starts from that side.
      vec3 from = position + normal * sign(cosine) * sky_info.w;
      float seen = sky_directions[i].w * sky_visibility(i, from, 2.5 * sky_blur.y, 4);
      sum += vec2(max(cosine, 0.0), max(-cosine, 0.0)) * seen;
    }
    sky_light = sum * 4.0 / sky_info.x;
  }
  gl_Position = world_to_clip * vec4(position, 1.0);
}
