#version 330 core
#include "frame.glsl"
#include "weave.glsl"
#ifdef OPEN
#include "shadow.glsl"
#endif
uniform vec3 outside_colour;   // linear
uniform vec3 inside_colour;    // linear
uniform vec4 finish;           // x: roughness, y: sheen, z: translucency, w: strength of the weave
uniform sampler2D scalar_map;
centroid in vec3 world;
centroid in vec3 world_normal;
centroid in float shown_scalar;
centroid in vec2 sky_light;
centroid in float decided_shadow;
in vec3 material;  // not centroid: its derivatives are used
layout(location = 0) out vec4 colour;  // encoded

// What arrives from all around with nothing in the way, as SkyLight has it.
float open_sky(vec3 normal) { return 0.75 + 0.25 * normal.y; }

// A lamp with some extent: light reaches a little around the edge of a form.
float wrapped(float cosine, float wrap) {
  float light = max((cosine + wrap) / (1.0 + wrap), 0.0);
  return light * light * (1.0 - 0.5 * wrap) + light * 0.5 * wrap;
}

// GGX (Walter et al. 2007) with the visibility approximated after Kelemen and Szirmay-Kalos (2001).
float highlight(vec3 normal, vec3 towards_light, vec3 towards_eye, float roughness) {
  vec3 halfway = normalize(towards_light + towards_eye);
  float a2 = roughness * roughness * roughness * roughness;
  float nh = max(dot(normal, halfway), 0.0);
  float lh = max(dot(towards_light, halfway), 0.1);
  float d = nh * nh * (a2 - 1.0) + 1.0;
  return 0.04 * a2 / (4.0 * d * d * lh * lh);
}

struct Light {
  float diffuse;   // times the surface's own colour
  float fringe;    // of cloth fibres and rim, nearly white
  float gloss;
};

Light gathered(vec3 normal, vec3 towards_eye, float open) {
  float key_cosine = dot(normal, towards_key.xyz);
#ifdef OPEN
  float key_light = towards_key.w * key_visibility(world, key_cosine >= 0.0 ? normal : -normal);
#else
  float key_light = towards_key.w * step(0.5, decided_shadow);
#endif
  float facing = max(dot(normal, towards_eye), 0.0);
  float grazing = (1.0 - facing) * (1.0 - facing) * (1.0 - facing);
  float direct = 0.80 * key_light * wrapped(key_cosine, 0.15);
  float through = 0.80 * key_light * finish.z * max(-key_cosine, 0.0);
  // The fill has no shadow map; what is closed to the sky is closed to it too.
  float openness = clamp(open / max(open_sky(normal), 0.05), 0.0, 1.0);
  float fill = towards_fill.w * wrapped(dot(normal, towards_fill.xyz), 0.3) * openness;
  // Closed folds lose more than their share, so that they read beside lit ones.
  float around = upper_colour.w * mix(0.25, 1.0, open) * mix(0.7, 1.0, openness);
  float rim = towards_rim.w * grazing * max(dot(normal, towards_rim.xyz), 0.0) * openness;
  Light light;
  light.diffuse = direct + through + fill + around;
  light.fringe = rim + finish.y * grazing * 0.85 * (around + 0.6 * direct + fill);
  light.gloss = key_light * max(key_cosine, 0.0) * highlight(normal, towards_key.xyz, towards_eye, finish.x);
  return light;
}

vec3 data_colour() {
  if (shown_scalar < -0.5) return vec3(0.21);
  float width = float(textureSize(scalar_map, 0).x);
  float t = (clamp(shown_scalar, 0.0, 1.0) * (width - 1.0) + 0.5) / width;
  return textureLod(scalar_map, vec2(t, 0.5), 0.0).rgb;
}

void main() {
  vec3 towards_eye = normalize(eye.xyz - world);
  vec3 normal = normalize(world_normal);
  float side = gl_FrontFacing ? 1.0 : -1.0;
  normal *= side;
  // Near a silhouette an interpolated normal can turn away from the eye; it is brought back to grazing.
  normal = normalize(normal - towards_eye * min(dot(normal, towards_eye), 0.0));
  Light light = gathered(normal, towards_eye, gl_FrontFacing ? sky_light.x : sky_light.y);
#ifdef DATA
  // Colours that carry numbers: enough shading to see the form, little enough to look up the number.
  // A dark colour cannot show form by getting darker, so a little light from the edges is added.
  vec3 seen = data_colour() * mix(1.0, light.diffuse / 1.15, 0.5) + vec3(0.1 * light.fringe);
#else
  vec3 base = gl_FrontFacing ? outside_colour : inside_colour;
  vec3 seen = base * light.diffuse * weave_brightness(material, finish.w) +
              mix(vec3(1.0), base, 0.6) * light.fringe + vec3(light.gloss);
#endif
  colour = vec4(linear_to_srgb_fast(tone_mapped(seen)), 1.0);
}
