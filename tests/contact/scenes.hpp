#pragma once

#include <memory>

#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::sim {

/// A level sheet with its middle at `at_m`, or a hanging sheet with the middle of its upper edge there.
struct Sheet {
  Index columns = 9;
  Index rows = 9;
  double width_m = 0.4;
  double length_m = 0.4;
  GridPlane plane = GridPlane::horizontal;
  Vec3 at_m = {0.0, 0.0, 0.0};
};

inline Mesh make_mesh(const Sheet& sheet) {
  const bool is_level = sheet.plane == GridPlane::horizontal;
  const Vec3 top_m = sheet.at_m - Vec3(0.0, 0.0, is_level ? 0.5 * sheet.length_m : 0.0);
  return make_grid({sheet.columns, sheet.rows, sheet.width_m, sheet.length_m, sheet.plane, top_m});
}

/// Two meshes as one garment.
inline Mesh both(Mesh first, const Mesh& second) {
  const auto count = static_cast<Index>(first.positions.size());
  first.quads.clear();
  first.positions.insert(first.positions.end(), second.positions.begin(), second.positions.end());
  for (const auto& [a, b, c] : second.triangles) {
    first.triangles.push_back({count + a, count + b, count + c});
  }
  return first;
}

/// A box from -0.1 to 0.1 m.
inline BodyMesh box() {
  std::vector<Vec3> positions_m;
  for (int v = 0; v < 8; ++v) {
    positions_m.push_back(0.1 * Vec3((v & 1) * 2 - 1, (v & 2) - 1, (v & 4) / 2 - 1));
  }
  return {std::make_shared<const BodyMeshData>(BodyMeshData{positions_m,
                                                            {{0, 2, 1},
                                                             {1, 2, 3},
                                                             {4, 5, 6},
                                                             {5, 7, 6},
                                                             {0, 1, 4},
                                                             {1, 5, 4},
                                                             {2, 6, 3},
                                                             {3, 6, 7},
                                                             {0, 4, 2},
                                                             {2, 4, 6},
                                                             {1, 3, 5},
                                                             {3, 7, 5}}})};
}

struct ContactScene {
  Mesh mesh;
  std::vector<Index> pins = {};
  Surroundings surroundings = {};
  Material material = {};
  int max_substeps = 2000;
  BoundedSettings bounded = {.max_stretch = 0.01, .contact = true, .threads = 1};
};

inline Simulation begin(ContactScene scene) {
  SimulationSettings settings;
  settings.solver.method = scene.bounded;
  settings.solver.max_substeps = scene.max_substeps;
  return {share(make_garment(std::move(scene.mesh), {}, scene.material)), std::move(scene.pins), settings,
          std::move(scene.surroundings)};
}

}  // namespace taut::sim
