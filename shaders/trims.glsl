// Hems, ribbed bands and seams. Features narrower than a drawn pixel fade to the mean, so that nothing aliases.
uniform sampler2D trim_data;      // four texels per trimmed triangle: at its corners the distance from the border
                                  // (m), the position along it (stitches), and the same for a seam; then width of
                                  // the hem (m), 1 if it is ribbed, thickness of the cloth and stitch (m)

// Rows of stitches of a hem, as fractions of its width, and of a ribbed band, beyond it.
const vec2 hem_rows = vec2(0.90, 0.68);
const float band_row = 1.13;
// Distance of the row of stitches beside a seam, and width of its groove, in stitches.
const float seam_row = 0.55;
const float groove = 0.3;
// Width of a thread, in stitches; its fraction of a stitch; its added brightness.
const float thread_width = 0.2;
const float thread_length = 0.75;
const float thread_light = 0.35;
// Slopes of the cloth at a row of stitches, at a seam and of ribs; ribs per stitch.
const float row_slope = 0.22;
const float groove_slope = 0.55;
const float rib_slope = 0.42;
const float ribs_per_stitch = 2.0;
// Fraction of light lost in a groove, beside a step and between ribs.
const float lost_light = 0.22;

// Difference of a spot from plain cloth: slope towards the eye, in m per m, and more.
struct Sewing {
  vec3 slope;
  float brightness;
  float doubled;  // fraction of double cloth
  float thread;   // fraction of sewing thread
};

// Returns the fraction of a pixel's extent around `place` that a line covers.
float covered(float place, float middle, float width, float pixel) {
  float upper = min(place + 0.5 * pixel, middle + 0.5 * width);
  return clamp((upper - max(place - 0.5 * pixel, middle - 0.5 * width)) / pixel, 0.0, 1.0);
}

// Returns x: slope across a row of stitches, y: its brightness, z: its fraction of thread. Lengths in stitches.
vec3 row_of_stitches(float place, float middle, float along, float pixel, float pixel_along) {
  float dip = 1.8 * thread_width;
  float down = covered(place, middle - 0.5 * dip, dip, pixel);
  float up = covered(place, middle + 0.5 * dip, dip, pixel);
  float dash = smoothstep(0.0, 0.12, 0.5 * thread_length - abs(fract(along) - 0.5) + 0.06);
  float shown = mix(thread_length, dash, clamp(2.0 - 4.0 * pixel_along, 0.0, 1.0));
  float thread = covered(place, middle, thread_width, pixel) * shown;
  float brightness = 1.0 - lost_light * 0.5 * (down + up) * (1.0 - thread) + thread_light * thread;
  return vec3(row_slope * (up - down), brightness, thread);
}

// Returns slope and brightness of a rib's cross-section, faded to its mean.
vec2 rib(float along, float pixel_along) {
  float shown = clamp(2.0 - 4.0 * ribs_per_stitch * pixel_along, 0.0, 1.0);
  float phase = 6.2831853 * ribs_per_stitch * along;
  return shown * vec2(-rib_slope * sin(phase), 0.5 * lost_light * (cos(phase) - 1.0)) +
         (1.0 - shown) * vec2(0.0, -0.5 * lost_light);
}

// Returns the sewing of a spot. `ab`, `ac`: sides of the triangle; `place`: position in it; `across`, `up`: its change
// per pixel.
Sewing sewn(int trim, bool front, vec3 ab, vec3 ac, vec2 place, vec2 across, vec2 up) {
  vec4 a = texelFetch(trim_data, texel(4 * trim), 0);
  vec4 b = texelFetch(trim_data, texel(4 * trim + 1), 0) - a;
  vec4 c = texelFetch(trim_data, texel(4 * trim + 2), 0) - a;
  vec4 band = texelFetch(trim_data, texel(4 * trim + 3), 0);
  vec4 at = a + place.x * b + place.y * c;
  vec4 to_right = across.x * b + across.y * c;
  vec4 upwards = up.x * b + up.y * c;
  vec4 pixel = sqrt(to_right * to_right + upwards * upwards) + 1e-5;
  vec3 facing = cross(ab, ac);
  vec3 towards_b = cross(ac, facing);
  vec3 towards_c = cross(facing, ab);
  vec3 from_border = normalize(b.x * towards_b + c.x * towards_c + 1e-12);
  vec3 along_border = normalize(b.y * towards_b + c.y * towards_c + 1e-12);
  vec3 from_seam = normalize(b.z * towards_b + c.z * towards_c + 1e-12);
  float stitch = band.w;
  Sewing sewing = Sewing(vec3(0.0), 1.0, 0.0, 0.0);

  // The hem or the band: a step down to the single cloth.
  float width = band.x;
  float ribbed = band.y;
  float step_width = front ? 1.5 * band.z : band.z;
  float steep = (front ? 0.35 : 0.7) * (1.0 + ribbed);
  float hem = float(width > 0.0);
  sewing.slope -= hem * steep * covered(at.x, width, step_width, pixel.x) * from_border;
  sewing.brightness -= hem * lost_light * (0.6 + 0.6 * ribbed) * covered(at.x, width + step_width, 1.6 * step_width, pixel.x);
  sewing.doubled = hem * covered(at.x, 0.0, 2.0 * width, pixel.x);
  vec2 rows = width * mix(hem_rows, vec2(band_row), ribbed);
  for (int i = 0; i < 2; ++i) {
    vec3 row = row_of_stitches(at.x / stitch, rows[i] / stitch, at.y, pixel.x / stitch, pixel.y);
    float shown = hem * (i == 0 ? 1.0 : 1.0 - ribbed);
    sewing.slope += shown * row.x * from_border;
    sewing.brightness *= mix(1.0, row.y, shown);
    sewing.thread += shown * row.z;
  }
  vec2 ribs = ribbed * sewing.doubled * rib(at.y, pixel.y);
  sewing.slope += ribs.x * along_border;
  sewing.brightness += ribs.y;

  // The seam: a groove, and stitches on its left.
  float beside = abs(at.z) / stitch;
  float beside_pixel = pixel.z / stitch;
  float in_groove = covered(beside, 0.5 * groove, groove, beside_pixel);
  sewing.slope += sign(at.z) * groove_slope * in_groove * clamp(1.0 - beside_pixel, 0.0, 1.0) * from_seam;
  sewing.brightness *= 1.0 - lost_light * covered(beside, 0.0, groove, beside_pixel);
  vec3 row = row_of_stitches(at.z / stitch, seam_row, at.w, beside_pixel, pixel.w);
  sewing.slope += row.x * from_seam;
  sewing.brightness *= row.y;
  sewing.thread = min(sewing.thread + row.z, 1.0);
  return sewing;
}
