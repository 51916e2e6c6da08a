#pragma once

#include <string>

#include "app/models/garment_loading.hpp"
#include "app/models/inspecting/remarks.hpp"
#include "app/models/reading/file_mesh.hpp"
#include "temporary_folder.hpp"

namespace taut::test {

/// Writes a file without units and axes and loads it. The model itself is simulated, without fitting.
inline app::LoadedGarment load(const TemporaryFolder& folder, const sim::Mesh& mesh) {
  app::Scene scene;
  scene.garment.mesh = app::MeshChoice::model;
  scene.garment.file = folder.write("garment.obj", app::obj_text(mesh, mesh.positions));
  return app::load_garment(scene);
}

/// Returns the messages about the garment, one line each.
inline std::string remarks(const app::LoadedGarment& loaded) {
  std::string text;
  for (const std::string& line : app::collect_remarks(loaded)) {
    text += line + '\n';
  }
  return text;
}

}  // namespace taut::test
