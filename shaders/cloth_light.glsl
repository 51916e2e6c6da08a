// Light of the studio reflected by cloth.

// Sines of the lamps' angular radii, by which light reaches around the edge of a form: larger lamps reach farther.
const float key_wrap = 0.1;
const float fill_wrap = 0.3;
// Colours of the lamps (slightly warm), the sky (slightly cold) and the floor's bounce (warm).
const vec3 key_colour = vec3(1.02, 1.0, 0.97);
const vec3 sky_colour = vec3(0.965, 1.0, 1.055);
const vec3 floor_bounce = vec3(1.13, 1.10, 1.04);
// Light of lit cloth on parts occluded from the sky, as a fraction of the key light.
const float key_bounce = 0.14;
// Factor of the light that passes through cloth, of which its colour then takes a part.
const float through_gain = 1.6;
// Roughness up to which cloth has its whole highlight, and from which it has none.
const float glossy = 0.4;
const float matt = 0.8;
// Factor of the rim lamp on fibres, for which it is meant.
const float rim_fringe = 2.0;
// Largest reflectance: cloth that reflected all light would glow where it occludes the sky.
const float whitest = 0.95;
// Fraction of the cloth's own colour in the fringe: fibres are dyed through, and a white fringe looks like plastic.
const float fringe_dyed = 0.75;

// Returns the light of an extended lamp on a matt surface: the cosine, but where the horizon cuts the lamp (a parabola
// that joins both ends smoothly).
float wrapped(float cosine, float wrap) {
  float risen = clamp(cosine, -wrap, wrap) + wrap;
  return max(cosine - wrap, 0.0) + risen * risen / (4.0 * wrap);
}

// Gloss of a satin's floats, which lie side by side along its warp. They are round across it, which spreads light by
// this factor, and they tint it with some of their own colour, as light passes through clear fibres.
const float spread_across = 3.5;
const float satin_gloss = 4.2;
const float satin_dyed = 0.5;
// Fraction of light that floats mirror and so keep from the layers below.
const float satin_dark = 0.22;

// Returns the highlight by GGX (Walter et al. 2007), anisotropic as by Burley (2012), with the visibility approximated
// after Kelemen and Szirmay-Kalos (2001). `warp`: unit vector across the normal, or 0 if threads do not matter.
float highlight(vec3 normal, vec3 towards_light, vec3 towards_eye, float roughness, vec3 warp) {
  vec3 halfway = normalize(towards_light + towards_eye);
  float along = roughness * roughness;
  float across = along * mix(1.0, spread_across, dot(warp, warp));
  float nh = max(dot(normal, halfway), 0.0);
  float wh = dot(warp, halfway);
  float lh = max(dot(towards_light, halfway), 0.1);
  float d = nh * nh + wh * wh / (along * along) + max(1.0 - nh * nh - wh * wh, 0.0) / (across * across);
  return 0.04 / (4.0 * along * across * d * d * lh * lh);
}

// Returns the fraction of uniform light that the fringe reflects towards the eye: the integral of fringes() over all
// directions, to 0.04 for a roughness from 0.4 to 1.
float fringe_albedo(float facing, float roughness) {
  vec3 powers = vec3(1.0, roughness, roughness * roughness);
  vec4 c = vec4(dot(powers, vec3(-0.1328, 0.3579, -0.0861)), dot(powers, vec3(0.4436, 0.1929, -0.2730)),
                dot(powers, vec3(-2.0675, 3.7912, -2.1580)), dot(powers, vec3(3.4039, -6.4489, 3.5817)));
  float x = 1.0 - facing;
  return max(c.x + x * (c.y + x * (c.z + x * c.w)), 0.0);
}

// Returns the fringe's reflection of each lamp, relative to a Lambertian surface: the distribution of Estevez and Kulla
// (2017), the visibility of Neubelt and Pettineo (2013). glTF's KHR_materials_sheen is the same.
vec3 fringes(vec3 cosines, vec3 to_eye, float facing, float roughness) {
  float a = roughness * roughness;
  vec3 lit = max(cosines, 0.0);
  vec3 halfway = (cosines + facing) * (cosines + facing) / max(2.0 + 2.0 * to_eye, 1e-3);
  vec3 d = (1.0 + 0.5 / a) * pow(max(1.0 - halfway, 1e-4), vec3(0.5 / a));
  return lit * d / (4.0 * (lit + facing - lit * facing) + 1e-3);
}

struct Finish {
  float roughness;
  float sheen;
  float sheen_roughness;
  float translucency;
  vec3 warp;  // see highlight()
};

struct Light {
  vec3 diffuse;  // to be multiplied by the surface's own colour
  vec3 through;  // light from behind, which passes more dyed fibres
  vec3 fringe;   // light of fibres that stand off
  vec3 gloss;
};

// Light from all around.
struct Ambient {
  vec3 light;
  float openness;  // visible fraction of the sky
};

// Returns the ambient light. `sky`: light of the sky; `far_side`: that on the other side; `base`: colour of
// surrounding cloth, which reflects light where it occludes the sky. It is linear in the sky, so that the mean of many
// passes is right: the geometric series of reflections is that of half the sky.
Ambient ambient_light(Sky sky, vec2 far_side, vec3 base, float translucency) {
  vec2 arrived = sky.light + translucency * far_side;
  vec3 around = upper_colour.w * (arrived.x * sky_colour + arrived.y * floor_bounce * lower_colour.rgb);
  vec3 cloth = min(base, whitest);
  vec3 bounced = cloth / (1.0 - 0.5 * cloth) *
                 (key_bounce * towards_key.w * key_colour + 0.25 * upper_colour.w * sky_colour);
  return Ambient(around + (1.0 - sky.open) * bounced, sky.open);
}

// Returns the light on a spot. `key`: fraction of the key light that arrives.
Light gathered(vec3 normal, vec3 towards_eye, float key, Ambient around, Finish finish) {
  float key_cosine = dot(normal, towards_key.xyz);
  vec3 key_light = towards_key.w * key * key_colour;
  float facing = max(dot(normal, towards_eye), 0.0);
  vec3 ambient = around.light;
  float openness = around.openness;
  vec3 direct = key_light * wrapped(key_cosine, key_wrap);
  // The fill light has no shadow map; occlusion of the sky occludes it too.
  float fill = towards_fill.w * wrapped(dot(normal, towards_fill.xyz), fill_wrap) * openness;
  mat3 towards_lamps = mat3(towards_key.xyz, towards_fill.xyz, towards_rim.xyz);
  vec3 lamps = fringes(normal * towards_lamps, towards_eye * towards_lamps, facing, finish.sheen_roughness);
  float albedo = fringe_albedo(facing, finish.sheen_roughness);
  Light light;
  float satin = dot(finish.warp, finish.warp);
  light.through = through_gain * key_light * finish.translucency * max(-key_cosine, 0.0);
  light.diffuse = (direct + fill + ambient) * (1.0 - finish.sheen * albedo) * (1.0 - satin_dark * satin);
  float beside_key = openness * (towards_fill.w * lamps.y + rim_fringe * towards_rim.w * lamps.z);
  light.fringe = finish.sheen * (key_light * lamps.x + beside_key + albedo * ambient);
  light.gloss = (1.0 - smoothstep(glossy, matt, finish.roughness)) * key_light * max(key_cosine, 0.0) *
                highlight(normal, towards_key.xyz, towards_eye, finish.roughness, finish.warp);
  // Satin also mirrors the softer lamp and the sky.
  float mirrored = 2.0 * facing * normal.y - towards_eye.y;
  float grazing = (1.0 - facing) * (1.0 - facing);
  vec3 sky = upper_colour.w * openness * (0.045 + 0.3 * grazing * grazing) * smoothstep(-0.3, 0.9, mirrored) * sky_colour;
  light.gloss += satin * (sky + fill * highlight(normal, towards_fill.xyz, towards_eye, finish.roughness, finish.warp));
  return light;
}
