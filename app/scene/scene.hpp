#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/models/model_arrays.hpp"
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

/// All there is to say about a run; nothing of how it is drawn.
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
};

}  // namespace taut::app
