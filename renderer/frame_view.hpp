#pragma once

#include "renderer/page/colour.hpp"

namespace taut::renderer {

/// A perspective camera. Lengths are in metres, angles in radians. +y is up in the world.
struct Camera {
  glm::vec3 eye{0.0F, 0.0F, 3.0F};  ///< position of the camera, world space
  glm::vec3 target{0.0F};           ///< point in the middle of the picture, world space
  glm::vec3 up{0.0F, 1.0F, 0.0F};   ///< not parallel to target - eye
  float vertical_fov_rad = 0.5F;    ///< full angle from the lower to the upper edge of the picture
  float near_m = 0.05F;             ///< distance of the near plane, above 0
  float far_m = 50.0F;              ///< distance of the far plane, above near_m

  /// Returns the matrix from world to eye space.
  glm::mat4 view() const;
  /// Returns the matrix from eye space to OpenGL clip space. `aspect` is width / height.
  glm::mat4 projection(float aspect) const;
};

/// Largest drawn absolute coordinate, in metres. Beyond it products of coordinates overflow a float.
inline constexpr float farthest_m = 1e9F;

/// An axis-aligned box, in metres.
struct Box {
  glm::vec3 lower{0.0F};
  glm::vec3 upper{0.0F};
};

/// Returns the smallest box around the points. NaN coordinates are ignored. Throws std::invalid_argument when
/// there are no points.
Box bounding_box(std::span<const glm::vec3> points);
/// Returns whether lower <= upper in every axis and all coordinates are within +-farthest_m.
bool is_near(const Box& box);
/// Returns the corners of a box.
std::array<glm::vec3, 8> box_corners(const Box& box);
/// Returns the smallest box around both boxes.
Box unite(const Box& a, const Box& b);

/// Direction, field of view and border for a camera that is fitted to a box or to points.
struct Framing {
  float azimuth_rad = 0.0F;       ///< direction of the eye around +y; 0: +z, pi/2: +x
  float elevation_rad = 0.0F;     ///< angle of the eye above the horizon, -pi/2 to pi/2, both excluded
  float vertical_fov_rad = 0.5F;  ///< see Camera::vertical_fov_rad
  float margin = 0.08F;           ///< free border on the tighter side, as a fraction of the picture, 0 to 0.49
};

/// Returns the closest camera that sees the whole box inside the margin, with near_m and far_m set. The box's
/// projection is centred in the picture. `aspect` is width / height. A box without extent counts as a cube of one
/// millimetre. Throws std::invalid_argument unless is_near(box), aspect is finite and positive, and the margin is 0 to
/// 0.49.
Camera fit_camera_to_box(const Box& box, const Framing& framing, float aspect);

/// Returns the points that decide how fit_camera_to_points places the camera: the outermost to the right, left, top and
/// bottom. Throws like it.
std::array<glm::vec3, 4> outermost_points(std::span<const glm::vec3> points, const Framing& framing, float aspect);

/// Fits the camera to the points themselves, closer than fit_camera_to_box to their bounding box. Throws like it, and
/// also without points.
Camera fit_camera_to_points(std::span<const glm::vec3> points, const Framing& framing, float aspect);

// The spans of these structs belong to the caller. They must live until SceneRenderer::draw returns.
// SceneRenderer checks their lengths, indices and values.

/// Binding of the cloth's threads. The warp runs along the second material coordinate.
enum class WeaveKind { knit, plain, twill, satin };

inline constexpr std::array all_weave_kinds = {WeaveKind::knit, WeaveKind::plain, WeaveKind::twill, WeaveKind::satin};

/// Returns the name in files.
const char* to_name(WeaveKind kind);

/// Fraction of the cloth's own colour, instead of white, in fibres that stand off; shaders/cloth_light.glsl has it too.
inline constexpr float fringe_dyed = 0.75F;

/// Material of a surface.
struct SurfaceStyle {
  Colour outside_colour = rgb(0x3F6FA8);  ///< colour of the side from which triangles are counter-clockwise
  /// Colour of the other side. None: derived from the outside colour (reverse_colour).
  std::optional<Colour> inside_colour;
  float roughness = 0.75F;        ///< width of the highlight; 0.05 glossy to 1 matt, clamped
  float sheen = 0.18F;            ///< 0 to 1; fraction of light reflected by fibres that stand off
  float sheen_roughness = 0.65F;  ///< width of the sheen, clamped to 0.4 to 1: low for a narrow fringe, high for a veil
  float translucency = 0.2F;      ///< 0 to 1; fraction of the key light that passes through
  float weave = 1.0F;             ///< contrast of the weave, 0 for none; needs material coordinates
  /// Binding of the cloth. Twill shows threads of the other side's colour on each side.
  WeaveKind weave_kind = WeaveKind::knit;
  float threads_per_m = 1100.0F;  ///< or columns of stitches of a knit; the default is jersey
  float unevenness = 0.3F;        ///< 0 to 1; variation of brightness between yarns and along them
  /// Colour of the threads of hems and seams. None: a lighter shade of the cloth.
  std::optional<Colour> stitch_colour;
};

/// Image of base colours laid over the colour of a surface, which shows where the image is transparent. Copies share
/// the pixels, which must not change: the renderer keeps the pixels of the last frame.
struct BaseColourMap {
  int width_px = 0;   ///< 1 to 16384
  int height_px = 0;  ///< 1 to 16384
  /// RGBA, 8 bits each: rows from top to bottom, sRGB, alpha not premultiplied.
  std::shared_ptr<const std::vector<std::uint8_t>> rgba;

  bool operator==(const BaseColourMap&) const = default;
};

/// Colours of some triangles of a surface.
struct BaseColour {
  Colour outside_colour = rgb(0xFFFFFF);
  Colour inside_colour = rgb(0xFFFFFF);
  BaseColourMap map = {};  ///< also visible on the inside; without pixels: none. Needs corner coordinates
};

/// One scalar per vertex, shown by a colour map on both sides instead of the style's colours.
struct ScalarColours {
  std::span<const float> values;  ///< n, one per vertex of the surface; a NaN is drawn grey
  float minimum = 0.0F;           ///< value of the lower end of the map
  float maximum = 1.0F;           ///< value of the upper end; above minimum
  ColourMap map = ColourMap::viridis;
};

/// Edges drawn over both sides of a surface.
struct Wireframe {
  std::span<const std::array<std::uint32_t, 2>> edges;  ///< vertex indices, each below n
  Colour colour = rgb(0x1A1A1A);
  float width_px = 1.0F;  ///< pixels of the finished picture; may be a fraction
  float opacity = 0.6F;   ///< 0 to 1
};

/// Coarse mesh that a surface was refined from, on which light is gathered. Its vertices are the first ones of the
/// surface.
struct Refinement {
  std::size_t coarse_vertices = 0;
  std::span<const std::uint32_t> coarse_triangles;  ///< three vertices per triangle
  /// Two earlier vertices per added vertex, in this order: its light is their mean.
  std::span<const std::array<std::uint32_t, 2>> parents;
  std::span<const std::uint32_t> parent_triangles;  ///< coarse triangle of each triangle
  float max_bulge_m = 0.0F;                         ///< largest distance of the surface from the coarse mesh
};

/// Triangle near hems, bands or seams, which are drawn by its corner values. Lengths are measured on the cloth at rest.
struct TrimmedTriangle {
  std::uint32_t triangle = 0;
  /// Values per corner: distance from the border in metres, below 0 beyond it; position along the border in stitches;
  /// distance from a seam in metres, below 0 on its right; position along it in stitches.
  std::array<glm::vec4, 3> corners{};
  float band_m = 0.0F;  ///< width of the hem; 0: none
  bool ribbed = false;  ///< the band is knitted across instead of hemmed
  float thickness_m = 0.001F;
  float stitch_m = 0.004F;
};

/// Triangles with smooth normals. n = number of vertices = positions.size().
struct SurfaceView {
  std::span<const glm::vec3> positions;      ///< n, metres, world space
  std::span<const glm::vec3> normals;        ///< n, of unit length, pointing outside
  std::span<const std::uint32_t> triangles;  ///< three vertex indices per triangle, each below n
  /// n or none, metres: rest position of each vertex, for the weave. None: no weave.
  std::span<const glm::vec3> material_coordinates;
  /// Three per triangle, one for each of its corners, or none: positions on base colour maps. x to the right, y up; a
  /// map covers 0 to 1 and repeats beyond.
  std::span<const glm::vec2> corner_coordinates;
  /// Colours instead of the style's; none: the style's.
  std::span<const BaseColour> base_colours;
  /// Indices into base_colours, one per triangle; none: all use the first.
  std::span<const std::uint32_t> base_colour_of_triangle;
  SurfaceStyle style;
  std::optional<ScalarColours> scalars;
  std::optional<Wireframe> wireframe;
  std::optional<Refinement> refinement;
  std::span<const TrimmedTriangle> trims;  ///< ascending
  bool casts_shadow = true;
};

/// Returns the coarse mesh of a refined surface, or the surface itself, for light and shadow.
inline SurfaceView coarse_surface(const SurfaceView& surface) {
  SurfaceView coarse = surface;
  if (surface.refinement) {
    coarse.positions = surface.positions.first(surface.refinement->coarse_vertices);
    coarse.normals = surface.normals.first(surface.refinement->coarse_vertices);
    coarse.triangles = surface.refinement->coarse_triangles;
  }
  return coarse;
}

/// Line segments. A segment that lies on a surface is drawn in front of it.
struct LineView {
  std::span<const glm::vec3> points;  ///< two per segment, metres, world space
  Colour colour{0.0F};
  float width_px = 1.5F;           ///< pixels of the finished picture
  float opacity = 1.0F;            ///< 0 to 1
  bool hidden_by_surfaces = true;  ///< false: drawn over all surfaces
};

/// Shaded spheres of one size and colour, e.g. pins.
struct SphereView {
  std::span<const glm::vec3> centres;  ///< metres, world space
  float radius_m = 0.01F;              ///< above 0
  Colour colour = rgb(0xC0392B);
  bool casts_shadow = true;
};

/// Flat discs that always face the camera, e.g. the mass points of a diagram.
struct PointView {
  std::span<const glm::vec3> centres;  ///< metres, world space
  Colour colour{0.0F};
  float diameter_px = 6.0F;        ///< pixels of the finished picture
  bool hidden_by_surfaces = true;  ///< false: drawn over all surfaces
};

/// Three-point lighting: key, fill and rim light, all at infinity. Directions point from the scene to the light, in
/// world space, with any length above 0. A matt white surface that faces a key light of strength 1 is white.
struct Lighting {
  glm::vec3 towards_key{-0.55F, 0.95F, 0.75F};
  glm::vec3 towards_fill{0.90F, 0.25F, 0.60F};
  glm::vec3 towards_rim{0.35F, 0.60F, -1.0F};
  float key = 1.2F;       ///< strength; the only light that casts shadows
  float fill = 0.12F;     ///< strength
  float rim = 0.30F;      ///< strength
  float ambient = 0.27F;  ///< strength of ambient light: strong from above, weak from below
};

/// Returns the default lighting turned around +y to the camera: key from the upper left of the picture, fill from the
/// right, rim from behind.
Lighting studio_lighting(const Camera& camera);

/// Background: a gradient from lower_colour at the middle of the picture to upper_colour above. The floor has
/// lower_colour and blends into the background at its edge.
struct Backdrop {
  Colour upper_colour = rgb(0xB9BFC6);
  Colour lower_colour = rgb(0xE2E1DE);
  bool plain = false;  ///< true: lower_colour everywhere, without a ground (a diagram)
  /// True: the picture has an alpha channel without a background. Only the floor's shadow is drawn, as black.
  bool transparent = false;
};

/// Everything drawn in one frame (one moment of the simulation).
struct FrameView {
  std::vector<SurfaceView> surfaces;
  std::vector<LineView> lines;
  std::vector<SphereView> spheres;
  std::vector<PointView> points;
  /// y of the floor, which receives shadows. None: no floor.
  std::optional<float> ground_height_m;
  Camera camera;
  Lighting lighting;
  Backdrop backdrop;
};

/// Largest number of passes of a picture.
inline constexpr int max_passes = 4096;

/// Size and quality of a picture. The defaults are for publication. On a slow machine reduce the most costly settings
/// first: samples to 1 saves a third of the time, sky_directions to 6 a tenth (folds get blotchy), then shadows to
/// false.
struct PictureSettings {
  int width_px = 1280;    ///< 1 to 16384
  int height_px = 720;    ///< 1 to 16384
  int samples = 4;        ///< per pixel, 1 to 64; above 1 counts as 4, or as 1 where the context has no 4
  int supersampling = 1;  ///< 1 to 8; factor of the drawn size, which is then averaged in linear light
  bool shadows = true;    ///< shadows of the key light
  /// Side of the square shadow map in texels, 256 to 8192. A small picture uses a smaller map. Larger is sharper.
  int shadow_map_px = 2048;
  /// 1, or 2 to shade squares of 2 by 2 pixels as one, with outlines spread over three pixels. Only with one sample.
  int shading_px = 1;
  /// Shadow map look-ups per pixel in a soft shadow's edge, 1 to 64. Fewer give grainy edges.
  int shadow_taps = 16;
  /// Directions tested for ambient occlusion of each vertex, 0 to 32. 0: no occlusion. Odd numbers count as the next
  /// even one. Fewer give blotchy folds.
  int sky_directions = 12;
  /// 1 to max_passes. Above 1 the picture is the mean of so many passes with one sample per pixel, each with its own
  /// place in the pixel, point of the key lamp and directions of the sky. It ignores samples, supersampling and
  /// shading_px.
  int passes = 1;

  /// Width over height.
  float aspect() const { return static_cast<float>(width_px) / static_cast<float>(height_px); }
};

/// Returns whether the frame is valid: lengths of spans, indices below n, finite positions and normals.
bool is_sound(const FrameView& frame);

/// Returns whether every setting is in its range.
bool is_sound(const PictureSettings& settings);

/// Throws std::invalid_argument unless both are sound and the camera's eye and target differ and are within 1e9 m.
void check(const FrameView& frame, const PictureSettings& settings);

/// Triangle mesh that owns its arrays, for bodies and pins. n = number of vertices = positions.size().
struct TriangleMesh {
  std::vector<glm::vec3> positions;      ///< n, metres
  std::vector<glm::vec3> normals;        ///< n, of unit length, pointing outside
  std::vector<std::uint32_t> triangles;  ///< three vertex indices each, counter-clockwise seen from outside
};

/// Returns a sphere of latitude rings. `segments`: vertices per ring, at least 3; there are half as many
/// rings.
TriangleMesh make_sphere(const glm::vec3& centre, float radius_m, int segments = 48);
/// Returns a cylinder from a to b (metres) with half spheres on its ends; a sphere when a equals b.
/// `segments` as in make_sphere.
TriangleMesh make_capsule(const glm::vec3& a, const glm::vec3& b, float radius_m, int segments = 48);

/// Fills `normals` with one unit normal per vertex. Each triangle is weighted by its angle at the vertex, so that the
/// triangulation of a face does not matter (Thuermer and Wuethrich 1998). n = number of vertices = positions.size().
/// `triangles` holds three vertex indices per triangle, counter-clockwise seen from outside. Triangles without area are
/// ignored. A vertex without other triangles gets +y. Requires normals.size() == n and indices below n (asserted).
void vertex_normals(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles,
                    std::span<glm::vec3> normals);

}  // namespace taut::renderer
