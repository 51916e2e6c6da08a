#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/models/file_vertices.hpp"
#include "app/models/garment_import.hpp"
#include "app/models/hanging.hpp"
#include "app/models/landmarks.hpp"
#include "app/models/placement.hpp"
#include "app/scene/scene.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// A scene's garment as it is simulated.
struct GarmentInScene {
  std::shared_ptr<const sim::Garment> garment;
  std::vector<sim::Index> pins;
  std::optional<std::vector<sim::Vec3>> start_m;  ///< by vertex; none: as modelled
  FileVertices file_vertices;  ///< in the mesh before it was subdivided; of a grid all its vertices
};

/// The same, and how it came about.
struct LoadedGarment : GarmentInScene {
  Landmarks landmarks;
  // Of a model file; a grid is made, not read.
  std::optional<ImportedModel> model;  ///< with its positions, without its triangles
  std::optional<sim::MeshReport> repairs;
  std::optional<Placement> placement;
  std::optional<Hanging> hanging;  ///< where the scene does not say what is held
};

/// Told what is begun, such as "reading dress.fbx": a large model takes seconds.
using StageReport = std::function<void(const std::string& stage)>;

/// Reads or makes the garment, maps it to springs, finds its landmarks and pins it.
/// Throws InputError naming the file or the key.
LoadedGarment load_garment(const Scene& scene, const StageReport& begin = {});

/// The scene's garment as the scene begins. What the scene leaves to the garment is settled here: a
/// simulation refuses surroundings in which it is not. Throws std::invalid_argument as sim::Simulation does,
/// and InputError on a force at a vertex that is not there.
sim::Simulation make_simulation(const Scene& scene, const GarmentInScene& loaded);

}  // namespace taut::app
