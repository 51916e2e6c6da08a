#pragma once

#include "sim/springs.hpp"
#include "sim/surface.hpp"

namespace taut::sim {

/// Smallest thickness of cloth. Contact planes leave a tenth of it, which exceeds the single-precision rounding of
/// vertices a metre apart.
inline constexpr double min_thickness_m = 1e-5;

/// Physical properties of cloth, independent of the mesh resolution.
struct Material {
  /// Must be above 0. The default is a light jersey. Wind moves heavier cloth less.
  double areal_density_kg_per_m2 = 0.15;
  /// Used by `bounded` and `implicit`. The default is a soft jersey. Denim has about ten times this value and folds
  /// less.
  double bending_rigidity_n_m = 5e-6;
  /// Stiffness of springs shorter than their rest length, used by `bounded` only. Lower values let the cloth crumple
  /// sooner. FrameReport::followed_compression_n_per_m is its effective upper limit.
  double compression_stiffness_n_per_m = 30.0;
  /// Tension over strain along warp and weft, and against shear per radian. `bounded` uses them if it bounds the
  /// surface. Either all are above 0, or all are 0: such cloth has no tension law and stretches up to its bound.
  double tensile_warp_n_per_m = 0.0;
  double tensile_weft_n_per_m = 0.0;
  double shear_n_per_m = 0.0;
  /// Largest strains along warp and weft: threads lock there.
  double warp_limit = 10.0;
  double weft_limit = 10.0;
  /// Thickness of a single layer by a gauge. It is the distance kept between layers and to bodies. Only `bounded` keeps
  /// layers apart.
  double thickness_m = 0.001;
  /// Coulomb's coefficient between layers, and for bodies without their own.
  double friction = 0.3;

  bool operator==(const Material&) const = default;
};

/// Returns whether tension depends on strain.
inline bool has_law(const Material& material) {
  return material.tensile_warp_n_per_m > 0.0 && material.tensile_weft_n_per_m > 0.0 && material.shear_n_per_m > 0.0;
}

/// Constant data of the cloth in a simulation.
struct Garment {
  Mesh mesh;  ///< mesh at rest; its edge lengths are the rest lengths of the springs
  Adjacency adjacency;
  Springs springs;
  std::vector<TriangleAtRest> triangles_at_rest;  ///< per triangle
  std::vector<double> masses_kg;                  ///< per vertex, all above 0
  Material material;
  /// Positions in m, one per vertex, of an untangled copy of a mesh that crosses itself at rest. Only distances at rest
  /// between parts of the cloth are measured there. Empty: the mesh has no such copy.
  std::vector<Vec3> untangled_m = {};
  /// Unit direction of the warp per triangle, in the plane of TriangleAtRest. Empty: the direction nearest to upright.
  std::vector<Vec2> warps = {};
  /// Material index per vertex: 0 is `material`, k is entry k - 1 of `others`. Empty: all vertices have `material`.
  /// `bounded` uses weight, bending and tension per vertex. `material` gives friction, compression stiffness and
  /// thickness; the latter is the largest of all.
  std::vector<std::uint8_t> material_indices = {};
  std::vector<Material> other_materials = {};

  const Material& material_at(Index vertex) const {
    return material_indices.empty() || material_indices[vertex] == 0 ? material
                                                                     : other_materials[material_indices[vertex] - 1];
  }
};

/// Maps the mesh to springs and gives each vertex its mass. Each triangle spreads its mass evenly over its
/// corners; so does each cell of a grid. A vertex gets at least 5 % of the mean mass, because the corrections
/// of springs cannot pass through a vertex of almost no mass. Throws std::invalid_argument if the areal
/// density is not above 0 or if any other value of the material is below 0.
Garment make_garment(Mesh mesh, const MappingSettings& mapping = {}, const Material& material = {});

/// Returns the garment with another material. Throws as make_garment does.
Garment with_material(Garment garment, const Material& material);

/// Returns the garment with several materials. Throws as make_garment does. Also throws if only some materials have a
/// tension law, or if the first one has no bending rigidity.
Garment with_other_materials(Garment garment, std::vector<std::uint8_t> material_of, std::vector<Material> others);

/// Returns the smallest areal density of all materials.
double min_density_kg_per_m2(const Garment& garment);

/// Returns a shared garment, so that simulations and observers need no copies.
inline std::shared_ptr<const Garment> share(Garment garment) {
  return std::make_shared<const Garment>(std::move(garment));
}

}  // namespace taut::sim
