#version 330 core
#include "frame.glsl"
#include "surface_buffers.glsl"
#include "weave.glsl"
#include "trims.glsl"
#include "light_maps.glsl"
#include "shadow.glsl"
#include "cloth_light.glsl"
// Shades visible triangles, once for every surface in a pixel: most triangles are so small that shading during
// rasterisation would process more pixels outside than inside.
uniform ivec4 corner;  // xy: lower left corner of the tile in the framebuffer, px
#ifdef MULTISAMPLED
uniform usampler2DMS visibility_buffer;  // four samples
uniform vec4 samples_x;         // positions of the samples in a pixel, 0..1
uniform vec4 samples_y;
#else
uniform usampler2D visibility_buffer;
#endif
uniform sampler2D scalar_maps;  // one row each
#ifdef BASE_COLOUR_MAPS
#include "base_colour_map.glsl"
#endif
layout(location = 0) out vec4 colour;  // linear, premultiplied; encoded with one sample unless it is one of many

// Returns the light of the sky at a spot: from sky and floor on the outside, and on the inside. `share`: weights of the
// second and third corner.
vec4 interpolated_sky(uvec3 corners, vec2 share) {
  ivec3 places = ivec3(corners);
  vec4 a = texelFetch(vertex_light, texel(places.x), 0);
  vec4 b = texelFetch(vertex_light, texel(places.y), 0);
  vec4 c = texelFetch(vertex_light, texel(places.z), 0);
  return a + share.x * (b - a) + share.y * (c - a);
}

// Spot of a triangle, with the change of its material coordinate per pixel.
struct Spot {
  vec3 world;
  vec3 normal;
  vec3 material;
  vec3 material_across;
  vec3 material_up;
  vec3 ab;   // sides of the triangle
  vec3 ac;
  vec2 warp;  // direction along ab and ac in which the material's second coordinate grows
  float weft_turn;  // 1 if the first or third coordinate grows to its right, seen from outside; otherwise -1
  mat3x2 place;  // position on the triangle, and its change to the right and upwards
};

#ifdef HALVED
const float shaded_px = 2.0;  // side of the squares shaded as one, drawn pixels
#elif defined(SAMPLED)
const float shaded_px = 0.5;  // passes have other places in the pixel
#else
const float shaded_px = 1.0;
#endif

// Returns the intersection of a ray and a triangle (Moeller and Trumbore 1997).
Spot spot_on(uvec3 corners, vec3 ray) {
  ivec3 first = 3 * ivec3(corners);
  vec4 a = texelFetch(vertex_data, texel(first.x), 0);
  vec4 b = texelFetch(vertex_data, texel(first.y), 0);
  vec4 c = texelFetch(vertex_data, texel(first.z), 0);
  vec3 ab = b.xyz - a.xyz;
  vec3 ac = c.xyz - a.xyz;
  vec3 from_a = eye.xyz - a.xyz;
  mat3 shares = mat3(cross(ac, from_a), cross(from_a, ab), cross(ac, ab));
  vec3 middle = ray * shares;
  vec3 right = middle + shaded_px * ray_across.xyz * shares;
  vec3 above = middle + shaded_px * ray_up.xyz * shares;
  vec2 place = middle.xy / middle.z;
  vec2 across = right.xy / right.z - place;
  vec2 up = above.xy / above.z - place;
  Spot spot;
  spot.ab = ab;
  spot.ac = ac;
  // The ray hits the triangle; clamping removes rounding errors.
  place = clamp(place, 0.0, 1.0);
  place /= max(place.x + place.y, 1.0);

  vec4 na = texelFetch(vertex_data, texel(first.x + 1), 0);
  vec4 nb = texelFetch(vertex_data, texel(first.y + 1), 0) - na;
  vec4 nc = texelFetch(vertex_data, texel(first.z + 1), 0) - na;
  vec4 ma = texelFetch(vertex_data, texel(first.x + 2), 0);
  vec4 mb = texelFetch(vertex_data, texel(first.y + 2), 0) - ma;
  vec4 mc = texelFetch(vertex_data, texel(first.z + 2), 0) - ma;
  spot.place = mat3x2(place, across, up);
  spot.world = a.xyz + place.x * ab + place.y * ac;
  spot.normal = normalize((na + place.x * nb + place.y * nc).xyz);
  spot.material = (ma + place.x * mb + place.y * mc).xyz;
  spot.material_across = across.x * mb.xyz + across.y * mc.xyz;
  spot.material_up = up.x * mb.xyz + up.y * mc.xyz;
  float bb = dot(mb.xyz, mb.xyz), bc = dot(mb.xyz, mc.xyz), cc = dot(mc.xyz, mc.xyz);
  spot.warp = vec2(cc * mb.y - bc * mc.y, bb * mc.y - bc * mb.y);
  // Direction of the weft in the plane that the material faces most.
  vec3 turn = cross(mb.xyz, mc.xyz);
  spot.weft_turn = sign(abs(turn.z) > abs(turn.x) ? turn.z : -turn.x);
  return spot;
}

vec3 scalar_colour(float scalar, float row) {
  vec2 size = vec2(textureSize(scalar_maps, 0));
  vec2 place = vec2(clamp(scalar, 0.0, 1.0) * (size.x - 1.0), row) + 0.5;
  return scalar < -0.5 ? vec3(0.21) : textureLod(scalar_maps, place / size, 0.0).rgb;
}

// Return the tones of cloth and of data colours. Those of many passes are mapped after averaging (film.frag).
#ifdef SAMPLED
vec3 developed(vec3 linear) { return linear; }
vec3 toned(vec3 linear) { return linear; }
#else
vec3 developed(vec3 linear) { return filmed(linear); }
vec3 toned(vec3 linear) { return tone_mapped(linear); }
#endif

// Returns the colour of a triangle in linear light.
vec3 shaded(int triangle, bool front, vec3 ray) {
  uvec4 corners = texelFetch(triangle_data, texel(triangle), 0);
  Spot spot = spot_on(corners.xyz, ray);
  int material = 5 * surface_of(corners.w);
  vec4 outside = texelFetch(material_data, texel(material), 0);
  vec4 inside = texelFetch(material_data, texel(material + 1), 0);
  vec4 rest = texelFetch(material_data, texel(material + 2), 0);
  Sewing sewing = Sewing(vec3(0.0), 1.0, 0.0, 0.0);
  // A loop instead of a branch, as in weave.glsl.
  for (int i = 0; i < (trim_of(corners.w) > 0 ? 1 : 0); ++i) {
    sewing = sewn(trim_of(corners.w), front, spot.ab, spot.ac, spot.place[0], spot.place[1], spot.place[2]);
  }
  vec3 towards_eye = normalize(eye.xyz - spot.world);
  // A hem is folded to the inside and shows the cloth's outside there.
  vec4 thread = texelFetch(material_data, texel(material + 3), 0);
  vec3 warp = spot.warp.x * spot.ab + spot.warp.y * spot.ac;
  warp *= inversesqrt(max(dot(warp, warp), 1e-30));
  vec3 weft = spot.weft_turn * cross(warp, spot.normal);
  vec2 key_in_cloth = vec2(dot(weft, towards_key.xyz), dot(warp, towards_key.xyz));
  Weave weave = weave_at(spot.material, spot.material_across, spot.material_up, key_in_cloth, int(thread.x), rest.y,
                         thread.y, thread.z);
  float turned = weave.other_side;
  vec3 base = mix(outside.rgb, inside.rgb, front ? turned : mix(1.0 - turned, turned, sewing.doubled));
#ifdef BASE_COLOUR_MAPS
  if (rest.w >= 0.0) {
    vec4 laid_on = base_colour(triangle, spot.place[0], spot.place[1], spot.place[2], rest.w) *
                   (front ? 1.0 : mix(shines_through, 1.0, sewing.doubled));
    base = base * (1.0 - laid_on.a) + laid_on.rgb;
  }
#endif
  vec4 stitch = texelFetch(material_data, texel(material + 4), 0);
  base = mix(base * sewing.brightness, stitch.rgb, sewing.thread * stitch.w);
  vec3 dented = normalize(spot.normal - weave.slope.x * weft - weave.slope.y * warp);
  vec3 normal = normalize((front ? dented : -dented) - sewing.slope);
  // Interpolated normals near a silhouette can face away from the eye; they are turned to grazing.
  normal = normalize(normal - towards_eye * min(dot(normal, towards_eye), 0.0));
  vec3 lit_side = dot(normal, towards_key.xyz) >= 0.0 ? normal : -normal;
#ifdef SAMPLED
  float lit = key_arriving(spot.world, lit_side);
#else
  float lit = key_visibility(spot.world, lit_side, true);
#endif
  float satin = float(int(thread.x) == satin_kind && dot(spot.warp, spot.warp) > 0.0);
  warp -= dot(warp, normal) * normal;
  warp *= satin * inversesqrt(max(dot(warp, warp), 1e-30));
  vec3 surrounding = rest.z < 0.0 ? base : vec3(0.0);
#ifdef SAMPLED
  Sky all;
  int pairs = int(sky_maps_shape.x);
  Sky sky = sky_light(spot.world, normal, pairs, all);
  // Less light comes from the far side: one pair is enough.
  vec2 far_side = sky_light(spot.world, -normal, min(pairs, 1), all).light;
#else
  vec4 both = interpolated_sky(corners.xyz, spot.place[0]);
  both = front ? both : both.zwxy;
  Sky sky = Sky(both.xy, both.x + 2.0 * both.y);
  vec2 far_side = both.zw;
#endif
  Ambient around = ambient_light(sky, far_side, surrounding, rest.x);
  Light light = gathered(normal, towards_eye, lit, around, Finish(outside.w, inside.w, thread.w, rest.x, warp));
  vec3 matt_light = base * light.diffuse + base * sqrt(base) * light.through +
                    mix(vec3(1.0), base, fringe_dyed) * light.fringe;
  vec3 cloth = matt_light * weave.brightness +
               light.gloss * mix(vec3(1.0), satin_gloss * mix(vec3(1.0), base, satin_dyed), satin);
#ifdef SCALARS
  // Data colours get enough shading to show the form, but little enough to read the number. A dark colour cannot show
  // form by darkening, so some light from the edges is added.
  vec3 shown = scalar_colour(spot.material.x, rest.z) * mix(1.0, light.diffuse.g / 1.15, 0.5) + 0.1 * light.fringe.g;
  return rest.z < 0.0 ? developed(cloth) : toned(shown);
#else
  return developed(cloth);
#endif
}

#ifdef MULTISAMPLED
bool share_a_corner(uvec3 a, uvec3 b) {
  return any(equal(a, b)) || any(equal(a, b.yzx)) || any(equal(a, b.zxy));
}

// Returns whether a sample shows the surface of `first`: triangles around one vertex, from the same side.
bool continues(uint sample_visible, uint first, uvec3 corners) {
  uvec3 others = texelFetch(triangle_data, texel(max(triangle_of(sample_visible), 0)), 0).xyz;
  return sample_visible != 0u && is_front(sample_visible) == is_front(first) && share_a_corner(others, corners);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - corner.xy;
  uvec4 left = uvec4(texelFetch(visibility_buffer, pixel, 0).r, texelFetch(visibility_buffer, pixel, 1).r,
                     texelFetch(visibility_buffer, pixel, 2).r, texelFetch(visibility_buffer, pixel, 3).r);
  vec4 sum = vec4(0.0);
  while (left != uvec4(0u)) {
    bvec3 none = equal(left.xyz, uvec3(0u));
    int i = !none.x ? 0 : !none.y ? 1 : !none.z ? 2 : 3;
    uint first = left[i];
    // The ray passes through the sample, as the triangle may miss the pixel's middle.
    vec3 ray = ray_through(vec2(pixel) + vec2(samples_x[i], samples_y[i]));
    uvec4 corners = texelFetch(triangle_data, texel(max(triangle_of(first), 0)), 0);
    bvec4 same = bvec4(continues(left.x, first, corners.xyz), continues(left.y, first, corners.xyz),
                       continues(left.z, first, corners.xyz), continues(left.w, first, corners.xyz));
    sum += 0.25 * dot(vec4(same), vec4(1.0)) * vec4(shaded(max(triangle_of(first), 0), is_front(first), ray), 1.0);
    left *= uvec4(not(same));
  }
  if (sum.a == 0.0) discard;
  colour = sum;
}
#else
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - corner.xy;
#ifdef HALVED
  // The first non-empty pixel of the four represents all of them; surface_halved.frag keeps their outline.
  pixel *= 2;
  uvec4 four = uvec4(texelFetch(visibility_buffer, pixel, 0).r, texelFetch(visibility_buffer, pixel + ivec2(1, 0), 0).r,
                     texelFetch(visibility_buffer, pixel + ivec2(0, 1), 0).r, texelFetch(visibility_buffer, pixel + ivec2(1, 1), 0).r);
  bvec3 none = equal(four.xyz, uvec3(0u));
  int i = !none.x ? 0 : !none.y ? 1 : !none.z ? 2 : 3;
  uint visible = four[i];
  pixel += ivec2(i & 1, i >> 1);
#else
  uint visible = texelFetch(visibility_buffer, pixel, 0).r;
#endif
  if (visible == 0u) discard;
  vec3 light = vec3(0.0);
  // A loop instead of a branch, as in weave.glsl.
  for (int shown = 0; shown < (visible == 0u ? 0 : 1); ++shown) {
    light = shaded(triangle_of(visible), is_front(visible), ray_through(vec2(pixel) + 0.5));
  }
#ifdef SAMPLED
  colour = vec4(light, 1.0);
#elif defined(HALVED)
  // Less than opaque beside an outline, where surface_halved.frag has more to do.
  colour = (any(equal(four, uvec4(0u))) ? 0.5 : 1.0) * vec4(linear_to_srgb_fast(light), 1.0);
#else
  colour = vec4(linear_to_srgb_fast(light), 1.0);
#endif
}
#endif
