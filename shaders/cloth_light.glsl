// The studio's light as cloth reflects it.

// Share of the key light that cloth reflects.
const float key_reflected = 0.80;
// How far light reaches around the edge of a form, cosine: larger lamps reach farther.
const float key_wrap = 0.15;
const float fill_wrap = 0.3;
// Ambient light of a side that sees nothing of the sky, shares of that of one that sees all: by what it sees, and by
// what is closed of what it could see. Closed folds lose more than their share, so that they read beside lit ones.
const float closed_ambient = 0.25;
const float closed_fold = 0.7;
// The fringe's share of the light from all around, and of the key light.
const float fringe_strength = 0.85;
const float fringe_key = 0.6;
// How far the fringe has the cloth's own colour: fibres are dyed through, and what stays white looks like plastic.
const float fringe_dyed = 0.85;

// Light from all around with nothing in the way, as SkyLight has it.
float open_sky(vec3 normal) { return 0.75 + 0.25 * normal.y; }

// A lamp with some extent: light reaches a little around the edge of a form.
float wrapped(float cosine, float wrap) {
  float light = max((cosine + wrap) / (1.0 + wrap), 0.0);
  return light * light * (1.0 - 0.5 * wrap) + light * 0.5 * wrap;
}

// How a satin's floats shine, which lie side by side along its warp: round across it, so that light is spread by this
// factor there, and with some of their own colour, as light goes in and out of fibres that are clear.
const float spread_across = 3.5;
const float satin_gloss = 3.0;
const float satin_dyed = 0.6;

// GGX (Walter et al. 2007), anisotropic as by Burley (2012), with the visibility approximated after Kelemen and
// Szirmay-Kalos (2001). `warp`: of length 1 across the normal, or 0 where threads do not matter.
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

struct Finish {
  float roughness;
  float sheen;
  float translucency;
  vec3 warp;  // see highlight()
};

struct Light {
  float diffuse;   // times the surface's own colour
  float fringe;    // of cloth fibres and rim, nearly white
  float gloss;
};

// `key`: how much of the key light arrives; `open`: how much of the sky.
Light gathered(vec3 normal, vec3 towards_eye, float key, float open, Finish finish) {
  float key_cosine = dot(normal, towards_key.xyz);
  float key_light = towards_key.w * key;
  float facing = max(dot(normal, towards_eye), 0.0);
  float grazing = (1.0 - facing) * (1.0 - facing) * (1.0 - facing);
  float direct = key_reflected * key_light * wrapped(key_cosine, key_wrap);
  float through = key_reflected * key_light * finish.translucency * max(-key_cosine, 0.0);
  // The fill has no shadow map; what is closed to the sky is closed to it too.
  float openness = clamp(open / max(open_sky(normal), 0.05), 0.0, 1.0);
  float fill = towards_fill.w * wrapped(dot(normal, towards_fill.xyz), fill_wrap) * openness;
  float around = upper_colour.w * mix(closed_ambient, 1.0, open) * mix(closed_fold, 1.0, openness);
  float rim = towards_rim.w * grazing * max(dot(normal, towards_rim.xyz), 0.0) * openness;
  Light light;
  light.diffuse = direct + through + fill + around;
  light.fringe = rim + finish.sheen * grazing * fringe_strength * (around + fringe_key * direct + fill);
  light.gloss = key_light * max(key_cosine, 0.0) *
                highlight(normal, towards_key.xyz, towards_eye, finish.roughness, finish.warp);
  // Satin shows the softer lamp too.
  light.gloss += dot(finish.warp, finish.warp) * fill *
                 highlight(normal, towards_fill.xyz, towards_eye, finish.roughness, finish.warp);
  return light;
}
