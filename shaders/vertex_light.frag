#version 330 core
#include "frame.glsl"
#include "surface_buffers.glsl"
#include "light_maps.glsl"
// Light of the sky at the vertices of all surfaces, in the layout of vertex_light in surface_buffers.glsl.
layout(location = 0) out vec4 light;

// Exponent of the occlusion of a vertex. Higher values darken folds, which few directions leave too bright.
const float fold_contrast = 1.25;

vec2 light_on_side(vec3 position, vec3 normal) {
  Sky all;
  Sky sky = sky_light(position, normal, int(sky_maps_shape.x), all);
  // The ratio to the open light of the same directions hides that they are few.
  vec2 open = open_light(normal.y);
  vec2 share = pow(sky.light / max(all.light, vec2(1e-3)), vec2(fold_contrast));
  return sky_maps_shape.x > 0.0 ? open * share : open;
}

void main() {
  int vertex = int(gl_FragCoord.y) * texels_per_row + int(gl_FragCoord.x);
  vec3 position = texelFetch(vertex_data, texel(3 * vertex), 0).xyz;
  vec3 normal = texelFetch(vertex_data, texel(3 * vertex + 1), 0).xyz;
  light = vec4(light_on_side(position, normal), light_on_side(position, -normal));
}
