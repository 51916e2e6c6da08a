#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "renderer/camera.hpp"
#include "renderer/page/colour.hpp"

namespace taut::renderer {

// Everything here is a view: the spans belong to the caller and have to live until SceneRenderer::draw
// returns.

/// How a surface meets the light.
struct SurfaceStyle {
  Colour outside_colour = rgb(0x3F6FA8);  ///< seen where triangles run counter-clockwise
  Colour inside_colour = rgb(0xD9A066);   ///< seen on the other side
  float roughness = 0.75F;                ///< 0.05 glossy to 1 matt; of the highlight
  float sheen = 0.4F;                     ///< 0 to 1; the soft bright fringe of cotton at grazing angles
  float translucency = 0.12F;             ///< 0 to 1; light that comes through from the other side
  float weave = 1.0F;  ///< 0 none to 1; contrast of the knit, seen where material coordinates are given
};

/// Numbers shown as colours instead of the style's colours, on both sides.
struct ScalarColours {
  std::span<const float> values;  ///< one for each position
  float minimum = 0.0F;           ///< shown as the lower end of the map
  float maximum = 1.0F;           ///< shown as the upper end; has to be above minimum
  ColourMap map = ColourMap::viridis;
};

/// Edges drawn over a surface, visible from both sides.
struct Wireframe {
  std::span<const std::uint32_t> edges;  ///< two indices into the surface's positions for each line
  Colour colour = rgb(0x1A1A1A);
  float width_px = 1.0F;  ///< in pixels of the finished picture, may be fractional
  float opacity = 0.6F;   ///< 0 to 1
};

/// Triangles with smooth normals.
struct SurfaceView {
  std::span<const glm::vec3> positions;      ///< metres
  std::span<const glm::vec3> normals;        ///< unit, one for each position, on the outside
  std::span<const std::uint32_t> triangles;  ///< three indices each
  /// Where each position lies in the material, metres: the garment's rest positions. Carries the weave, which
  /// moves with the cloth; empty: smooth.
  std::span<const glm::vec3> material_coordinates;
  SurfaceStyle style;
  std::optional<ScalarColours> scalars;
  std::optional<Wireframe> wireframe;
  bool casts_shadow = true;
  bool filled = true;  ///< false: the wireframe alone, see-through
};

/// Separate line segments, in front of a surface they lie on.
struct LineView {
  std::span<const glm::vec3> points;  ///< two for each segment, metres
  std::span<const Colour> colours;    ///< one for each point, or one for all
  float width_px = 1.5F;              ///< in pixels of the finished picture
  float opacity = 1.0F;               ///< 0 to 1
  bool hidden_by_surfaces = true;     ///< false: always on top
};

/// Shaded balls, e.g. pins.
struct SphereView {
  std::span<const glm::vec3> centres;  ///< metres
  float radius_m = 0.01F;
  Colour colour = rgb(0xC0392B);
  bool casts_shadow = true;
};

/// Round flat marks of constant size on the picture, e.g. mass points of a diagram.
struct PointView {
  std::span<const glm::vec3> centres;  ///< metres
  std::span<const Colour> colours;     ///< one for each centre, or one for all
  float diameter_px = 6.0F;            ///< in pixels of the finished picture
  bool hidden_by_surfaces = true;
};

/// Three lights of a photographer's studio. Directions point from the scene towards the light, in world
/// space, and need not be of unit length; strengths are relative to a surface facing the key light.
struct Lighting {
  glm::vec3 towards_key{-0.55F, 0.95F, 0.75F};
  glm::vec3 towards_fill{0.90F, 0.25F, 0.60F};
  glm::vec3 towards_rim{0.35F, 0.60F, -1.0F};
  float key = 1.0F;  ///< the only light with a shadow
  float fill = 0.22F;
  float rim = 0.30F;
  float ambient = 0.42F;  ///< from the sky of the studio and, weaker, from its floor
  float penumbra = 1.0F;  ///< softness of the shadow's edge; 0 is as hard as the shadow map allows
};

/// The same studio turned to the camera: key from the upper left of the picture, fill from the right, rim
/// from behind.
Lighting studio_lighting(const Camera& camera);

/// What is behind and below. Above the horizon the two colours blend upwards; the ground blends into the
/// lower one.
struct Backdrop {
  Colour upper_colour = rgb(0xDDE1E6);
  Colour lower_colour = rgb(0xF4F4F2);
  bool plain = false;  ///< true: lower_colour everywhere, without a ground (a diagram, a cut-out)
};

/// One picture's worth of things to draw.
struct FrameView {
  std::vector<SurfaceView> surfaces;
  std::vector<LineView> lines;
  std::vector<SphereView> spheres;
  std::vector<PointView> points;
  std::optional<float>
      ground_height_m;  ///< y of the studio floor, which receives shadows; none: backdrop alone
  Camera camera;
  Lighting lighting;
  Backdrop backdrop;
};

/// How the picture is made. The defaults are for publication. What a window lowers first when the machine is
/// too slow, dearest first: samples to 1 (a third of the time), sky_directions to 12 (a tenth; folds get a
/// little blotchy), shadows to false.
struct PictureSettings {
  int width_px = 1280;
  int height_px = 720;
  int samples = 4;        ///< multisampling: 1, or 4 for anything above where the context offers as many
  int supersampling = 1;  ///< drawn this many times as wide and high, then averaged in linear light; 1 to 8
  bool shadows = true;
  /// Side of the square shadow map, 256 to 8192; less is taken where the picture is too small to show it.
  int shadow_map_px = 2048;
  /// With one sample: side of the square of drawn pixels that are shaded as one, 1 or 2. Outlines stay sharp.
  int shading_px = 1;
  /// Taps that soften a shadow's edge in each pixel, 1 to 64; fewer are grainy.
  int shadow_taps = 16;
  /// Directions that test how much sky each vertex sees, 0 to 64; odd numbers count as the next even one, 0:
  /// no ambient occlusion.
  int sky_directions = 24;
};

}  // namespace taut::renderer
