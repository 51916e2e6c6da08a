#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/models/model_arrays.hpp"
#include "renderer/camera.hpp"
#include "renderer/frame_view.hpp"
#include "sim/garment.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"
#include "sim/surroundings.hpp"

namespace taut::app {

/// A regular grid, or a model file where one is named.
struct GarmentSource {
  std::filesystem::path file;   ///< empty: the grid
  double scale = 0.0;           ///< the file's unit in metres; 0: the file's own, or a guess (placement.hpp)
  std::optional<ModelAxis> up;  ///< of the file; none: the file's own, or a guess
  double weld_m = 0.0;          ///< borders nearer to each other than this are sewn
  int subdivisions = 0;         ///< of the file's triangles, four for one each time
  sim::GridSettings grid;
};

/// The vertex nearest to a point, in metres.
struct NearestTo {
  sim::Vec3 point_m = {0.0, 0.0, 0.0};
};

/// Vertices that are held: a landmark of the garment or a name of `pin_names` (pins.hpp), a vertex by its
/// number in the garment's file (file_vertices.hpp), or the vertex nearest to a point.
using PinSelector = std::variant<std::string, sim::Index, NearestTo>;

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

/// All there is to say about a run and its pictures; what a scene file holds.
struct Scene {
  std::string name;  ///< how it was asked for; not a key of the file
  std::string title;
  GarmentSource garment;
  sim::GarmentSettings mapping;
  std::optional<std::vector<PinSelector>> pins;  ///< none: by its top
  sim::SimulationSettings simulation;
  sim::Surroundings surroundings;
  int frames = 600;
  bool allow_exceeding_bound = false;  ///< a frame that breaks the solver's promise does not fail the run
  CameraSettings camera;
  PictureStyle picture;
};

}  // namespace taut::app
