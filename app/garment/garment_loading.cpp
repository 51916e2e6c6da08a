#include "app/garment/garment_loading.hpp"

#include <stdexcept>
#include <utility>

#include "app/errors.hpp"
#include "app/scene/pins.hpp"

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

}  // namespace

LoadedGarment load_garment(const Scene& scene) {
  LoadedGarment loaded;
  const bool is_grid = scene.garment.file.empty();
  sim::Mesh mesh = is_grid ? sim::make_grid(scene.garment.grid) : read_mesh(scene.garment, loaded);
  if (!is_grid) {
    loaded.landmarks = read_landmarks(scene.garment.file, scene.garment.scale, mesh);
  }
  const PinTargets targets{mesh, loaded.landmarks, is_grid ? &scene.garment.grid : nullptr};
  std::vector<sim::Index> pins = select_pins(scene.pins, targets);
  loaded.garment = sim::make_garment(std::move(mesh), scene.mapping, std::move(pins));
  return loaded;
}

}  // namespace taut::app
