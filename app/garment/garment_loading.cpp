#include "app/garment/garment_loading.hpp"

#include <stdexcept>
#include <utility>

#include "app/errors.hpp"
#include "app/scene/pins.hpp"
#include "sim/subdivide.hpp"

namespace taut::app {
namespace {

sim::Mesh read_mesh(const GarmentSource& source, LoadedGarment& loaded) {
  loaded.model = import_garment(source.file);
  sim::Mesh soup;
  soup.triangles = loaded.model->triangles;
  soup.positions = loaded.model->positions;
  for (sim::Vec3& position : soup.positions) {
    position *= source.scale;
  }
  try {
    sim::ValidatedMesh valid = sim::weld_and_validate(soup);
    loaded.repairs = valid.report;
    return std::move(valid.mesh);
  } catch (const std::invalid_argument& error) {
    throw InputError("cannot use the garment '" + source.file.string() + "': " + error.what());
  }
}

sim::PinnedMesh subdivided(sim::PinnedMesh pinned, int times) {
  for (int i = 0; i < times; ++i) {
    if (!pinned.mesh.quads.empty()) {
      throw InputError("garment.subdivisions is for models; give a grid more columns and rows instead");
    }
    pinned = sim::subdivide(pinned);
  }
  return pinned;
}

}  // namespace

LoadedGarment load_garment(const Scene& scene) {
  LoadedGarment loaded;
  const bool is_grid = scene.garment.file.empty();
  sim::Mesh mesh = is_grid ? sim::make_grid(scene.garment.grid) : read_mesh(scene.garment, loaded);
  if (!is_grid) {
    loaded.landmarks = read_landmarks(scene.garment.file, scene.garment.scale, mesh);
  }
  // Of the mesh as it was read: what is named keeps its vertices when it is subdivided.
  const PinTargets targets{mesh, loaded.landmarks, is_grid ? &scene.garment.grid : nullptr};
  std::vector<sim::Index> pins = select_pins(scene.pins, targets);
  sim::PinnedMesh pinned = subdivided({std::move(mesh), std::move(pins)}, scene.garment.subdivisions);
  loaded.garment = sim::make_garment(std::move(pinned.mesh), scene.mapping, std::move(pinned.pins));
  return loaded;
}

}  // namespace taut::app
