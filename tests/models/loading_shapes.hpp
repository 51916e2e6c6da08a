#pragma once

#include <string>

#include "app/models/file_mesh.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/inspection.hpp"
#include "temporary_folder.hpp"

namespace taut::test {

/// Loaded as a file without units and axes, to be simulated as it is.
inline app::LoadedGarment load(const TemporaryFolder& folder, const sim::Mesh& mesh) {
  app::Scene scene;
  scene.garment.mesh = app::MeshChoice::model;
  scene.garment.file = folder.write("garment.obj", app::obj_text(mesh, mesh.positions));
  return app::load_garment(scene);
}

/// Returns the messages about it, a line each.
inline std::string remarks(const app::LoadedGarment& loaded) {
  std::string text;
  for (const std::string& line : app::remarks_of(loaded)) {
    text += line + '\n';
  }
  return text;
}

}  // namespace taut::test
