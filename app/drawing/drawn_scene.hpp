#pragma once

#include <array>
#include <optional>

#include "app/scene/scene.hpp"
#include "renderer/camera.hpp"
#include "renderer/frame_view.hpp"

namespace taut::app {

struct CameraSettings {
  renderer::Framing framing = {.azimuth_rad = 0.35F, .elevation_rad = 0.17F, .vertical_fov_rad = 0.5F};
  std::optional<renderer::Box> box;  ///< what has to be in the picture; none: the garment's reach
  std::optional<glm::vec3> eye;      ///< with `target` instead of framing
  std::optional<glm::vec3> target;
};

enum class SurfaceLook {
  shaded,
  stretch,    ///< coloured by the stretch of the structural springs
  wireframe,  ///< the springs alone, see-through
};

enum class GroundKind {
  automatic,  ///< on a level plane collider, or else a little below everything in the picture
  none,
  fixed,
};

struct Ground {
  GroundKind kind = GroundKind::automatic;
  double height_m = 0.0;
};

struct PictureStyle {
  renderer::PictureSettings settings;
  SurfaceLook surface = SurfaceLook::shaded;
  bool wireframe = false;
  std::optional<std::array<double, 2>> stretch_range;  ///< none: up to the bound (promise.hpp)
  renderer::ColourMap stretch_colours = renderer::ColourMap::viridis;  ///< not a key of the file
  renderer::SurfaceStyle cloth;
  Ground ground;
  bool rest_outline = false;  ///< where the garment's borders were modelled
  bool show_pins = true;
  bool legend = true;  ///< where the surface shows the stretch
};

/// A scene and, beside it, how it is drawn: all that a scene file holds.
struct DrawnScene : Scene {
  CameraSettings camera;
  PictureStyle picture;
};

/// The stretch at the two ends of the colours: as the scene says, or else from 0 to the bound, or to 5 %
/// where there is none.
std::array<double, 2> shown_stretch_range(const DrawnScene& scene);

}  // namespace taut::app
