#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "sim/material.hpp"
#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/mesh.hpp"
#include "sim/springs.hpp"

namespace taut::sim {

/// What the cloth is: nothing here changes while it is simulated.
struct Garment {
  Mesh mesh;  ///< at rest; its edge lengths are the springs' rest lengths
  Adjacency adjacency;
  Springs springs;
  std::vector<double> masses_kg;  ///< of every vertex
  Material material;
};

/// Maps the mesh to springs and spreads each face's mass evenly over its corners.
/// Throws std::invalid_argument on a density that is not above 0, or anything else of the material below 0.
Garment make_garment(Mesh mesh, const MappingSettings& mapping = {}, const Material& material = {});

/// The garment made of another material. Throws as make_garment does.
Garment with_material(Garment garment, const Material& material);

/// To be shared and not copied: by simulations, and by those who look at them.
inline std::shared_ptr<const Garment> share(Garment garment) {
  return std::make_shared<const Garment>(std::move(garment));
}

}  // namespace taut::sim
