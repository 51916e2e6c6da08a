#pragma once

#include "sim/springs.hpp"
#include "sim/surface.hpp"

namespace taut::sim {

/// No cloth is thinner than this: planes leave a tenth of it, which is more than single precision rounds away
/// from vertices a metre from each other.
inline constexpr double least_thickness_m = 1e-5;

/// The physical properties of the cloth. They do not depend on how fine the mesh is.
struct Material {
  /// Must be above 0. The default is a light jersey. Wind moves heavier cloth less.
  double areal_density_kg_per_m2 = 0.15;
  /// Used by `bounded` and `implicit`. The default is a soft jersey. Denim has about ten times this value and
  /// folds less.
  double bending_rigidity_n_m = 5e-6;
  /// Used by `bounded` only: the stiffness of springs that are shorter than their rest length. A lower value
  /// lets the cloth crumple sooner. For its upper limit see FrameReport::followed_compression_n_per_m.
  double compression_stiffness_n_per_m = 30.0;
  /// Used by `bounded` where it holds the surface: tension over strain along the warp and the weft, and
  /// against shear per radian. All are 0 in cloth that has no such law, which gives as far as its bound lets
  /// it, or all above 0.
  double tensile_warp_n_per_m = 0.0;
  double tensile_weft_n_per_m = 0.0;
  double shear_n_per_m = 0.0;
  /// The strains at which threads lock.
  double warp_limit = 10.0;
  double weft_limit = 10.0;
  /// The thickness of a single layer by a gauge. It is the distance kept between layers and to bodies. Solvers
  /// other than `bounded` do not keep layers apart.
  double thickness_m = 0.001;
  /// Coulomb's coefficient, between layers and for bodies that have none of their own.
  double friction = 0.3;

  bool operator==(const Material&) const = default;
};

/// Whether its tension depends on its strain.
inline bool has_law(const Material& material) {
  return material.tensile_warp_n_per_m > 0.0 && material.tensile_weft_n_per_m > 0.0 && material.shear_n_per_m > 0.0;
}

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
  /// Cloth of several materials, as layers that are worn over each other are: per vertex, the number of its own
  /// in `others`, from 1, or 0 for `material`. Empty: all is of `material`. `bounded` tells them apart by weight,
  /// bending and tension; distance, of the thickest, friction and resistance to compression are those of `material`.
  std::vector<std::uint8_t> material_of = {};
  std::vector<Material> others = {};

  const Material& material_at(Index vertex) const {
    return material_of.empty() || material_of[vertex] == 0 ? material : others[material_of[vertex] - 1];
  }
};

/// Maps the mesh to springs and gives each vertex its mass. Each triangle spreads its mass evenly over its
/// corners; so does each cell of a grid. A vertex gets at least 5 % of the mean mass, because the corrections
/// of springs cannot pass through a vertex of almost no mass. Throws std::invalid_argument if the areal
/// density is not above 0 or if any other value of the material is below 0.
Garment make_garment(Mesh mesh, const MappingSettings& mapping = {}, const Material& material = {});

/// The same garment made of another material. Throws as make_garment does.
Garment with_material(Garment garment, const Material& material);

/// The same garment with vertices of other materials. Throws as make_garment does, and if one of them has a law and
/// another has none, or if the garment's own bends by itself.
Garment with_others(Garment garment, std::vector<std::uint8_t> material_of, std::vector<Material> others);

/// The least areal density of any of its cloth.
double least_density_kg_per_m2(const Garment& garment);

/// Moves the garment to where several simulations and observers can share it without copies.
inline std::shared_ptr<const Garment> share(Garment garment) {
  return std::make_shared<const Garment>(std::move(garment));
}

}  // namespace taut::sim
