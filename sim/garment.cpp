#include "sim/garment.hpp"

namespace taut::sim {
namespace {

/// Smallest mass of a vertex, as a fraction of the mean mass. A vertex of almost no mass between heavy ones passes on
/// almost nothing of a correction, whatever the number of sweeps. Larger values change the mass of more vertices.
constexpr double min_mass_fraction = 0.05;

double area(const Mesh& mesh, std::size_t triangle) {
  assert(triangle < mesh.triangles.size());
  const auto [a, b, c] = corners_at_rest(mesh, triangle);
  return glm::length(glm::cross(b - a, c - a)) / 2.0;
}

void raise_to_min_mass(std::vector<double>& masses) {
  const double mean = std::accumulate(masses.begin(), masses.end(), 0.0) / static_cast<double>(masses.size());
  for (double& mass : masses) mass = std::max(mass, min_mass_fraction * mean);
}

std::vector<double> lumped_masses(const Garment& garment) {
  const Mesh& mesh = garment.mesh;
  const auto density = [&](Index v) { return garment.material_at(v).areal_density_kg_per_m2; };
  std::vector<double> masses(mesh.positions.size(), 0.0);
  // Grid cells share their mass among four corners: by triangles, the arbitrary diagonal would make two of them twice
  // as heavy.
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    for (const Index v : mesh.quads[q]) {
      masses[v] += density(v) * (area(mesh, 2 * q) + area(mesh, 2 * q + 1)) / 4.0;
    }
  }
  for (std::size_t t = 2 * mesh.quads.size(); t < mesh.triangles.size(); ++t) {
    for (const Index v : mesh.triangles[t]) masses[v] += density(v) * area(mesh, t) / 3.0;
  }
  raise_to_min_mass(masses);
  return masses;
}

void require_usable(const Material& material) {
  if (!(material.areal_density_kg_per_m2 > 0.0)) {
    throw std::invalid_argument("the areal density must be above 0 kg/m2");
  }
  if (!(material.thickness_m >= 0.0 && material.friction >= 0.0 && material.bending_rigidity_n_m >= 0.0 &&
        material.compression_stiffness_n_per_m >= 0.0)) {
    throw std::invalid_argument(
        "the thickness, friction, bending rigidity and compression stiffness of cloth must be at least 0");
  }
  const int stiffness_count =
      (material.tensile_warp_n_per_m > 0.0) + (material.tensile_weft_n_per_m > 0.0) + (material.shear_n_per_m > 0.0);
  if (stiffness_count != 3 && (stiffness_count != 0 || material.tensile_warp_n_per_m < 0.0 ||
                               material.tensile_weft_n_per_m < 0.0 || material.shear_n_per_m < 0.0)) {
    throw std::invalid_argument(
        "the tensile stiffness along warp and weft and the shear stiffness of cloth must all be above 0 N/m, "
        "or all 0 for none");
  }
}

}  // namespace

Garment make_garment(Mesh mesh, const MappingSettings& mapping, const Material& material) {
  require_usable(material);
  Garment garment;
  garment.mesh = std::move(mesh);
  garment.adjacency = make_adjacency(garment.mesh);
  garment.springs = map_to_springs(garment.mesh, garment.adjacency, mapping);
  garment.triangles_at_rest = triangles_at_rest(garment.mesh);
  garment.material = material;
  garment.masses_kg = lumped_masses(garment);
  return garment;
}

Garment with_material(Garment garment, const Material& material) {
  require_usable(material);
  const bool weighs_else = material.areal_density_kg_per_m2 != garment.material.areal_density_kg_per_m2;
  garment.material = material;
  if (weighs_else) garment.masses_kg = lumped_masses(garment);
  return garment;
}

Garment with_other_materials(Garment garment, std::vector<std::uint8_t> material_of, std::vector<Material> others) {
  assert(material_of.size() == garment.mesh.positions.size());
  for (const Material& other : others) {
    require_usable(other);
    if (has_law(other) != has_law(garment.material)) {
      throw std::invalid_argument("either all materials of cloth have tensile and shear stiffness, or none");
    }
    if (!(garment.material.bending_rigidity_n_m > 0.0)) {
      throw std::invalid_argument("the bending rigidity of cloth of several materials must be above 0");
    }
  }
  for (const Material& other : others) {
    garment.material.thickness_m = std::max(garment.material.thickness_m, other.thickness_m);
  }
  garment.material_indices = std::move(material_of);
  garment.other_materials = std::move(others);
  garment.masses_kg = lumped_masses(garment);
  return garment;
}

double min_density_kg_per_m2(const Garment& garment) {
  double min_kg_per_m2 = garment.material.areal_density_kg_per_m2;
  for (const Material& other : garment.other_materials)
    min_kg_per_m2 = std::min(min_kg_per_m2, other.areal_density_kg_per_m2);
  return min_kg_per_m2;
}

}  // namespace taut::sim
