#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/scene/model_units.hpp"
#include "app/scene/run_settings.hpp"
#include "sim/material.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/springs.hpp"
#include "sim/surroundings.hpp"

namespace taut::app {

/// A regular grid, or a model file where one is named.
struct GarmentSource {
  std::filesystem::path file;   ///< empty: the grid
  std::optional<double> scale;  ///< the file's unit in metres; none: the file's own, or a guess
  std::optional<ModelAxis> up;  ///< of the file; none: the file's own, or a guess
  double weld_m = 0.0;          ///< borders nearer to each other than this are sewn
  int subdivisions = 0;         ///< of the file's triangles, four for one each time
  /// A model file whose vertices are the garment's, in metres with y up: where the cloth begins. Empty: at
  /// rest, as it was modelled.
  std::filesystem::path start;
  sim::GridSettings grid;
};

/// The vertex nearest to a point, in metres.
struct NearestTo {
  sim::Vec3 point_m = {0.0, 0.0, 0.0};
};

/// Vertices that are held: a landmark of the garment or a name of `pin_names` (pins.hpp), a vertex by its
/// number in the garment's file (file_vertices.hpp), or the vertex nearest to a point.
using PinSelector = std::variant<std::string, sim::Index, NearestTo>;

/// All there is to say about a run; nothing of how it is drawn.
struct Scene {
  std::string name;  ///< how it was asked for; not a key of the file
  std::string title;
  GarmentSource garment;
  sim::MappingSettings mapping;
  sim::Material material;
  std::optional<std::vector<PinSelector>> pins;  ///< none: by its top
  RunSettings simulation;
  sim::Surroundings surroundings;                ///< but for the distance of layers
  std::optional<double> layer_distance_m = 0.0;  ///< none: what suits the garment's mesh
  std::filesystem::path checkpoint;  ///< a saved moment to begin with (run_checkpoint.hpp); empty: none
  int frames = 600;
};

}  // namespace taut::app
