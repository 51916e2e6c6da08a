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

/// Largest absolute coordinate that is drawn, metres. Beyond it products of coordinates overflow a float.
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
std::array<glm::vec3, 8> corners_of(const Box& box);
/// Returns the smallest box around both boxes.
Box united(const Box& a, const Box& b);

/// Direction, field of view and border for a camera that is fitted to a box or to points.
struct Framing {
  float azimuth_rad = 0.0F;       ///< direction of the eye around +y; 0: +z, pi/2: +x
  float elevation_rad = 0.0F;     ///< of the eye above the horizon, -pi/2 to pi/2, both excluded
  float vertical_fov_rad = 0.5F;  ///< as Camera::vertical_fov_rad
  float margin = 0.08F;           ///< free border on the tighter side, share of the picture, 0 to 0.49
};

/// Returns the closest camera that sees the whole box inside the margin, with near_m and far_m set. The box's
/// projection is centred in the picture. `aspect` is width / height. A box without extent counts as a cube of
/// one millimetre. Throws std::invalid_argument unless is_near(box), aspect is finite and positive, and the
/// margin is 0 to 0.49.
Camera fit_camera_to_box(const Box& box, const Framing& framing, float aspect);

/// Returns those of the points that decide how fit_camera_to_points places the camera: the ones farthest to
/// the right, to the left, up and down. Throws std::invalid_argument as it does.
std::array<glm::vec3, 4> outermost_points(std::span<const glm::vec3> points, const Framing& framing, float aspect);

/// As fit_camera_to_box, but fits the points themselves, which is closer than their bounding box. Throws
/// std::invalid_argument also when there are no points.
Camera fit_camera_to_points(std::span<const glm::vec3> points, const Framing& framing, float aspect);

// The spans of these structs belong to the caller. They must live until SceneRenderer::draw returns.
// SceneRenderer checks their lengths, indices and values.

/// How the threads of cloth run. The warp runs along the second material coordinate.
enum class WeaveKind { knit, plain, twill, satin };

inline constexpr std::array all_weave_kinds = {WeaveKind::knit, WeaveKind::plain, WeaveKind::twill, WeaveKind::satin};

/// The name used in files.
const char* name_of(WeaveKind kind);

/// How far fibres that stand off have the cloth's own colour, and not white; shaders/cloth_light.glsl has it too.
inline constexpr float fringe_dyed = 0.75F;

/// The material of a surface.
struct SurfaceStyle {
  Colour outside_colour = rgb(0x3F6FA8);  ///< of the side from which triangles are counter-clockwise
  /// The colour of the other side. None: the reverse of the outside's (reverse_of).
  std::optional<Colour> inside_colour;
  float roughness = 0.75F;        ///< of the highlight; 0.05 glossy to 1 matt, clamped
  float sheen = 0.35F;            ///< 0 to 1; how much of the light fibres that stand off reflect
  float sheen_roughness = 0.65F;  ///< of these, clamped to 0.4 to 1: low for a narrow fringe, high for a veil
  float translucency = 0.12F;     ///< 0 to 1; share of the key light that passes through
  float weave = 1.0F;             ///< contrast of the weave, 0 for none; needs material coordinates
  /// Of twill, threads of the other side's colour show between those of a side.
  WeaveKind weave_kind = WeaveKind::knit;
  float threads_per_m = 1100.0F;  ///< or columns of stitches of a knit; jersey
  float unevenness = 0.14F;       ///< 0 to 1; how much yarns differ in brightness, and along their length
  /// The colour of the threads of hems and seams. None: a lighter shade of the cloth.
  std::optional<Colour> stitch_colour;
};

/// An image of base colours that is laid on a surface, over its colour where it is transparent. Copies share
/// the pixels, which must not change: the renderer keeps those of the last frame.
struct BaseColourMap {
  int width_px = 0;   ///< 1 to 16384
  int height_px = 0;  ///< 1 to 16384
  /// RGBA, 8 bits each: rows from top to bottom, sRGB, alpha not premultiplied.
  std::shared_ptr<const std::vector<std::uint8_t>> rgba;

  bool operator==(const BaseColourMap&) const = default;
};

/// The colours of some triangles of a surface.
struct BaseColour {
  Colour outside_colour = rgb(0xFFFFFF);
  Colour inside_colour = rgb(0xFFFFFF);
  BaseColourMap map = {};  ///< shines through to the inside; without pixels: none. Needs corner coordinates
};

/// One scalar per vertex, shown through a colour map on both sides instead of the style's colours.
struct ScalarColours {
  std::span<const float> values;  ///< n, one per vertex of the surface; a NaN is drawn grey
  float minimum = 0.0F;           ///< has the colour at the lower end of the map
  float maximum = 1.0F;           ///< has the colour at the upper end; above minimum
  ColourMap map = ColourMap::viridis;
};

/// Edges drawn over a surface, on both sides.
struct Wireframe {
  std::span<const std::array<std::uint32_t, 2>> edges;  ///< vertex indices, each below n
  Colour colour = rgb(0x1A1A1A);
  float width_px = 1.0F;  ///< pixels of the finished picture; may be a fraction
  float opacity = 0.6F;   ///< 0 to 1
};

/// The coarser mesh that a surface was refined from, at which light is gathered. Its vertices are the first
/// ones of the surface.
struct Refinement {
  std::size_t coarse_vertices = 0;
  std::span<const std::uint32_t> coarse_triangles;  ///< three vertices per triangle
  /// For each vertex that was added, in this order, two that come before it: the light is their mean.
  std::span<const std::array<std::uint32_t, 2>> parents;
  std::span<const std::uint32_t> parent_triangles;  ///< one per triangle: the coarse one it lies in
  float most_bulge_m = 0.0F;                        ///< how far the surface is from the coarse mesh
};

/// A triangle near what is sewn: hems, bands and seams are drawn where the corners say. Lengths are those of
/// the cloth at rest.
struct TrimmedTriangle {
  std::uint32_t triangle = 0;
  /// At each corner: distance from the border in metres, below 0 beyond it; place along the border in
  /// stitches; distance from a seam in metres, below 0 on its right; place along it in stitches.
  std::array<glm::vec4, 3> corners{};
  float band_m = 0.0F;  ///< width of the hem; 0: none
  bool ribbed = false;  ///< the band is knitted across instead
  float thickness_m = 0.001F;
  float stitch_m = 0.004F;
};

/// Triangles with smooth normals. n = number of vertices = positions.size().
struct SurfaceView {
  std::span<const glm::vec3> positions;      ///< n, metres, world space
  std::span<const glm::vec3> normals;        ///< n, of unit length, pointing outside
  std::span<const std::uint32_t> triangles;  ///< three vertex indices per triangle, each below n
  /// n or none, metres: the rest position of each vertex, at which the weave is evaluated. None: no weave.
  std::span<const glm::vec3> material_coordinates;
  /// Three per triangle, one for each of its corners, or none: places on base colour maps. x to the right, y
  /// up; a map reaches from 0 to 1 and is repeated beyond.
  std::span<const glm::vec2> corner_coordinates;
  /// Instead of the style's colours; none: those.
  std::span<const BaseColour> base_colours;
  /// Indices into base_colours, one per triangle; none: all have the first.
  std::span<const std::uint32_t> base_colour_of_triangle;
  SurfaceStyle style;
  std::optional<ScalarColours> scalars;
  std::optional<Wireframe> wireframe;
  std::optional<Refinement> refinement;
  std::span<const TrimmedTriangle> trims;  ///< ascending
  bool casts_shadow = true;
};

/// Returns the coarser mesh of a refined surface, or the surface itself: what light and shadow are found for.
inline SurfaceView coarse_of(const SurfaceView& surface) {
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
  std::span<const Colour> colours;    ///< one per point, or one for all
  float width_px = 1.5F;              ///< pixels of the finished picture
  float opacity = 1.0F;               ///< 0 to 1
  bool hidden_by_surfaces = true;     ///< false: drawn over all surfaces
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
  std::span<const Colour> colours;     ///< one per centre, or one for all
  float diameter_px = 6.0F;            ///< pixels of the finished picture
  bool hidden_by_surfaces = true;      ///< false: drawn over all surfaces
};

/// Three-point lighting: key, fill and rim light, all at infinity. Directions point from the scene to the
/// light, in world space, and may have any length above 0. Strength 1 is that of the default key light.
struct Lighting {
  glm::vec3 towards_key{-0.55F, 0.95F, 0.75F};
  glm::vec3 towards_fill{0.90F, 0.25F, 0.60F};
  glm::vec3 towards_rim{0.35F, 0.60F, -1.0F};
  float key = 1.0F;       ///< strength; the only light that casts shadows
  float fill = 0.18F;     ///< strength
  float rim = 0.30F;      ///< strength
  float ambient = 0.34F;  ///< strength of the light from all around: strong from above, weak from below
};

/// Returns the default lighting turned around +y to the camera: key from the upper left of the picture, fill
/// from the right, rim from behind.
Lighting studio_lighting(const Camera& camera);

/// The background: a gradient from lower_colour at the middle of the picture to upper_colour above. The floor
/// has lower_colour and blends into the background at its edge.
struct Backdrop {
  Colour upper_colour = rgb(0xDDE1E6);
  Colour lower_colour = rgb(0xF4F4F2);
  bool plain = false;  ///< true: lower_colour everywhere, without a ground (a diagram)
  /// True: the picture has an alpha channel and nothing is behind. Of the floor its shadow stays, as black.
  bool transparent = false;
};

/// All that is drawn of one frame (one moment of the simulation).
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

/// Size and quality of a picture. The defaults are for publication. On a slow machine lower first what costs
/// most: samples to 1 saves a third of the time, sky_directions to 12 a tenth (folds get blotchy), then
/// shadows to false.
struct PictureSettings {
  int width_px = 1280;    ///< 1 to 16384
  int height_px = 720;    ///< 1 to 16384
  int samples = 4;        ///< per pixel, 1 to 64; above 1 counts as 4, or as 1 where the context has no 4
  int supersampling = 1;  ///< 1 to 8; drawn this many times as wide and high, then averaged in linear light
  bool shadows = true;    ///< of the key light
  /// Side of the square shadow map in texels, 256 to 8192. A small picture uses a smaller map. Larger is
  /// sharper.
  int shadow_map_px = 2048;
  /// 1, or 2 to shade squares of 2 by 2 pixels as one; outlines stay sharp. Only with one sample.
  int shading_px = 1;
  /// Shadow map look-ups per pixel in a soft shadow's edge, 1 to 64. Fewer give grainy edges.
  int shadow_taps = 16;
  /// Directions in which each vertex is tested for ambient occlusion, 0 to 64. 0: no occlusion. Odd numbers
  /// count as the next even one. Fewer give blotchy folds.
  int sky_directions = 24;

  /// Width over height.
  float aspect() const { return static_cast<float>(width_px) / static_cast<float>(height_px); }
};

/// Whether the frame keeps what frame_view.hpp requires: lengths of spans, indices below n, finite positions
/// and normals.
bool is_sound(const FrameView& frame);

/// Whether every setting is in its range.
bool is_sound(const PictureSettings& settings);

/// Throws std::invalid_argument unless both are sound and the camera's eye and target differ and are no
/// farther than 1e9 m.
void check(const FrameView& frame, const PictureSettings& settings);

/// A triangle mesh that owns its arrays, for bodies and pins. n = number of vertices = positions.size().
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

/// Fills `normals` with one unit normal per vertex, in which each triangle counts by its angle there (Thuermer and
/// Wuethrich 1998): how a face is cut into triangles does not matter. n = number of vertices = positions.size().
/// `triangles` holds three vertex indices per triangle, counter-clockwise seen from outside. Triangles without area are
/// ignored. A vertex without any other triangle gets +y. Requires normals.size() == n and indices below n
/// (asserted).
void vertex_normals(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles,
                    std::span<glm::vec3> normals);

}  // namespace taut::renderer
