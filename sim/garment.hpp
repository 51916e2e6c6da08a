#pragma once

#include <vector>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/mesh.hpp"
#include "sim/springs.hpp"

namespace taut::sim {

/// What the cloth is: nothing here changes while it is simulated.
struct Garment {
  Mesh mesh;  ///< at rest; its edge lengths are the springs' rest lengths
  Adjacency adjacency;
  Springs springs;
  std::vector<double> masses_kg;              ///< of every vertex, pinned or not
  std::vector<double> inverse_masses_per_kg;  ///< 0 where pinned: a pinned end has infinite mass
  std::vector<Index> pins;                    ///< ascending, each once
  double areal_density_kg_per_m2 = 0.0;
};

struct GarmentSettings {
  MappingSettings mapping;
  double areal_density_kg_per_m2 = 0.15;  ///< a light jersey; heavier cloth answers wind less
};

/// Maps the mesh to springs and spreads each face's mass evenly over its corners.
/// Throws std::invalid_argument on a pin that is no vertex or a density that is not positive.
Garment make_garment(Mesh mesh, const GarmentSettings& settings, std::vector<Index> pins);

/// Holds the garment by these vertices and no others, in any order.
/// Throws std::invalid_argument on a pin that is no vertex; nothing has changed then.
void hold_by(Garment& garment, std::vector<Index> pins);

}  // namespace taut::sim
