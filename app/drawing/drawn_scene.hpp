#pragma once

#include <array>
#include <optional>

#include "app/scene/scene.hpp"
#include "renderer/camera.hpp"
#include "renderer/frame_view.hpp"

namespace taut::app {

/// The camera of a scene's pictures.
struct CameraSettings {
  renderer::Framing framing = {.azimuth_rad = 0.35F, .elevation_rad = 0.17F, .vertical_fov_rad = 0.5F};
  std::optional<renderer::Box> box;  ///< what has to be in the picture, in metres; empty: expected_reach()
  std::optional<glm::vec3> eye;      ///< in metres; with `target` it replaces framing
  std::optional<glm::vec3> target;   ///< in metres
};

/// How the cloth's surface is drawn.
enum class SurfaceLook {
  shaded,
  stretch,    ///< coloured by stretch
  wireframe,  ///< the springs alone; surfaces are not drawn
};

/// Of what the stretch is shown as colours.
enum class StretchOf {
  springs,  ///< at each vertex the largest of the structural springs there
  surface,  ///< at each vertex the largest of the triangles there
};

/// Where the floor of a picture is.
enum class GroundKind {
  automatic,  ///< on a level plane if there is one, else a little below all that is shown
  none,       ///< no floor
  fixed,      ///< at Ground::height_m
};

/// The floor of a picture.
struct Ground {
  GroundKind kind = GroundKind::automatic;
  double height_m = 0.0;
};

/// How a scene's pictures are drawn.
struct PictureStyle {
  renderer::PictureSettings settings;
  SurfaceLook surface = SurfaceLook::shaded;
  bool wireframe = false;  ///< the springs drawn over the surface
  bool smooth = true;      ///< a smooth surface through the vertices instead of the simulated triangles
  StretchOf stretch_of = StretchOf::surface;
  /// Stretch at the two ends of the colours; empty: shown_stretch_range().
  std::optional<std::array<double, 2>> stretch_range;
  renderer::ColourMap stretch_colours = renderer::ColourMap::viridis;  ///< not a key of the file
  renderer::SurfaceStyle cloth;
  Ground ground;
  bool rest_outline = false;  ///< draws the garment's borders where they were modelled
  bool show_pins = true;
  bool legend = true;  ///< the colour bar, if the surface shows the stretch
};

/// A scene and how it is drawn: all that a scene file can say.
struct DrawnScene : Scene {
  CameraSettings camera;
  PictureStyle picture;
};

/// The stretch at the two ends of the colours. If the scene does not set it: from 0 to the solver's bound, or
/// to 0.05 if there is no bound.
std::array<double, 2> shown_stretch_range(const DrawnScene& scene);

/// The bound to be marked beside the colours: the solver's. Empty if it has none or does not hold what the
/// colours show.
std::optional<double> shown_bound(const DrawnScene& scene);

inline constexpr std::array all_stretch_of = {StretchOf::springs, StretchOf::surface};

/// The name used in files.
const char* name_of(StretchOf shown);

/// The title of the colours' legend.
const char* legend_title(StretchOf shown);

}  // namespace taut::app
