#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "sim/material.hpp"
#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/mesh.hpp"
#include "sim/springs.hpp"
#include "sim/surface.hpp"

namespace taut::sim {

/// The cloth itself. Nothing here changes while the cloth is simulated.
struct Garment {
  Mesh mesh;  ///< at rest; its edge lengths are the rest lengths of the springs
  Adjacency adjacency;
  Springs springs;
  std::vector<TriangleAtRest> triangles_at_rest;  ///< per triangle
  std::vector<double> masses_kg;                  ///< per vertex, all above 0
  Material material;
  /// Where a mesh that crosses itself at rest has been moved apart, in m, one entry per vertex; empty: it
  /// does not cross itself, or has not. How near parts of the cloth lie to each other is measured there, and
  /// nothing else.
  std::vector<Vec3> parted_m = {};
  /// Per triangle, the direction of the warp in the plane of TriangleAtRest, of length 1. Empty: as upright as
  /// it can be.
  std::vector<Vec2> warps = {};
};

/// Maps the mesh to springs and gives each vertex its mass. Each triangle spreads its mass evenly over its
/// corners; so does each cell of a grid. A vertex gets at least 5 % of the mean mass, because the corrections
/// of springs cannot pass through a vertex of almost no mass. Throws std::invalid_argument if the areal
/// density is not above 0 or if any other value of the material is below 0.
Garment make_garment(Mesh mesh, const MappingSettings& mapping = {}, const Material& material = {});

/// The same garment made of another material. Throws as make_garment does.
Garment with_material(Garment garment, const Material& material);

/// Moves the garment to where several simulations and observers can share it without copies.
inline std::shared_ptr<const Garment> share(Garment garment) {
  return std::make_shared<const Garment>(std::move(garment));
}

}  // namespace taut::sim
