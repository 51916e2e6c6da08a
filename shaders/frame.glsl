// Data shared by all shaders of a frame; mirrored by FrameBlock in renderer/gl/gl_objects.hpp. Linear light throughout.
const int max_sky_pairs = 16;  // pairs of opposite directions of the sky

layout(std140) uniform Frame {
  mat4 world_to_clip;
  mat4 world_to_shadow;     // to texture coordinates and depth, each 0..1
  vec4 eye;                 // xyz: position, m
  vec4 towards_key;         // xyz: unit; w: strength
  vec4 towards_fill;
  vec4 towards_rim;
  vec4 upper_colour;        // rgb; w: ambient strength
  vec4 lower_colour;        // rgb; w: 1 for a plain backdrop
  vec4 ground;              // x, z: middle of the lit floor, m; y: height, m; w: its radius, m
  vec4 viewport;            // xy: size of this tile in drawn pixels; z: drawn pixels per picture pixel; w: height of
                            // the picture in drawn pixels
  vec4 shadow;              // x: side of a texel, m; y: 1 / texels; z: depth range, m; w: tangent of the light's
                            // angular radius, 0 for no shadows
  vec4 shadow_blur;         // x: radius of the widest blur of a shadow, texels of the map; y: blur taps on surfaces,
                            // z: on the floor; w: largest distance of surfaces from their casters' meshes, m
  vec4 shadow_bounds;       // xy: lower, zw: upper corner of all casters, in the shadow map
  vec4 ground_light_area;   // xy: lower x and z, m; zw: 1 / extent, 1/m
  vec4 backdrop_horizon;    // x, y: sines of the elevations at the start and end of the backdrop's gradient;
                            // z: 1 if only shadows are drawn of backdrop and floor
  vec4 ray_corner;          // xyz: direction from the eye to the tile's lower left corner; w: distance of that corner
                            // from the left of the picture, drawn pixels
  vec4 ray_across;          // xyz: change of that direction per drawn pixel to the right; w: width of the picture
  vec4 ray_up;              // xyz: change per drawn pixel upwards; w: distance from the bottom, drawn pixels
  mat4 world_to_sky[max_sky_pairs];  // like world_to_shadow, for the upper direction of each pair
  vec4 towards_sky[max_sky_pairs];   // xyz: that direction, unit
  vec4 sky_floor;           // x: 1 if a floor is shown that shadows darken; yzw: mean colour of all casters, linear
  vec4 sky_maps_shape;      // x: pairs, 0 for an open sky; y: side of a texel, m; blur of a direction's shadow: z: on
                            // surfaces, fraction of the map, w: on the floor, per depth, 0 for none
};

// Fraction of the floor's light from the key light. Higher values darken its shadow.
const float key_share = 0.6;

// Returns the direction from the eye through a position in the tile, in drawn pixels; not of unit length.
vec3 ray_through(vec2 place) { return ray_corner.xyz + place.x * ray_across.xyz + place.y * ray_up.xyz; }

// Linear light above which highlights are compressed. Lower values keep more of them but show fewer true colours.
const float knee = 0.65;

vec3 srgb_to_linear(vec3 encoded) {
  return mix(encoded / 12.92, pow((encoded + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), encoded));
}

// Returns the encoded colour to a fifth of a step of 255 (coefficients: I. Taylor, "sRGB approximations for HLSL",
// 2012). Square roots are machine instructions; powers are long polynomials.
vec3 linear_to_srgb_fast(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  vec3 root2 = sqrt(c);
  vec3 root4 = sqrt(root2);
  vec3 root8 = sqrt(root4);
  vec3 upper = 0.662002687 * root2 + 0.684122060 * root4 - 0.323583601 * root8 - 0.0225411470 * c;
  return mix(c * 12.92, upper, step(vec3(0.0031308), c));
}

vec3 linear_to_srgb(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(c * 12.92, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), c));
}

// Maps tones, exact below the knee, so that data colours match the legend. Above it the brightest channel approaches 1
// and scales the others, so that highlights keep their hue.
vec3 tone_mapped(vec3 linear) {
  float peak = max(max(linear.r, linear.g), max(linear.b, 1e-4));
  float over = max(peak - knee, 0.0) / (1.0 - knee);
  float mapped = peak > knee ? knee + (1.0 - knee) * over / (1.0 + over) : peak;
  return linear * (mapped / peak);
}

// Maps tones like film: highlights lose some colour before they are white. Exact below the knee.
vec3 filmed(vec3 linear) {
  vec3 over = max(linear - knee, 0.0) / (1.0 - knee);
  vec3 each = min(linear, knee) + (1.0 - knee) * over / (1.0 + over);
  return mix(tone_mapped(linear), each, 0.4);
}
