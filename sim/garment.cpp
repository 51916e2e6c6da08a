#include "sim/garment.hpp"

namespace taut::sim {
namespace {

/// The least mass of a vertex, as a fraction of the mean mass. A vertex of almost no mass between heavy ones
/// passes on almost nothing of a correction, whatever the number of sweeps. A larger value changes the mass
/// of more vertices.
constexpr double least_mass = 0.05;

double area(const Mesh& mesh, std::size_t triangle) {
  const auto [a, b, c] = corners_at_rest(mesh, triangle);
  return glm::length(glm::cross(b - a, c - a)) / 2.0;
}

void raise_to_least_mass(std::vector<double>& masses) {
  const double mean = std::accumulate(masses.begin(), masses.end(), 0.0) / static_cast<double>(masses.size());
  for (double& mass : masses) mass = std::max(mass, least_mass * mean);
}

std::vector<double> lumped_masses(const Garment& garment) {
  const Mesh& mesh = garment.mesh;
  const auto density = [&](Index v) { return garment.material_at(v).areal_density_kg_per_m2; };
  std::vector<double> masses(mesh.positions.size(), 0.0);
  // Grid cells share their mass among four corners: by triangles, the arbitrary choice of the diagonal
  // would make two of them twice as heavy.
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    for (const Index v : mesh.quads[q]) {
      masses[v] += density(v) * (area(mesh, 2 * q) + area(mesh, 2 * q + 1)) / 4.0;
    }
  }
  for (std::size_t t = 2 * mesh.quads.size(); t < mesh.triangles.size(); ++t) {
    for (const Index v : mesh.triangles[t]) masses[v] += density(v) * area(mesh, t) / 3.0;
  }
  raise_to_least_mass(masses);
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
  const int given =
      (material.tensile_warp_n_per_m > 0.0) + (material.tensile_weft_n_per_m > 0.0) + (material.shear_n_per_m > 0.0);
  if (given != 3 && (given != 0 || material.tensile_warp_n_per_m < 0.0 || material.tensile_weft_n_per_m < 0.0 ||
                     material.shear_n_per_m < 0.0)) {
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

Garment with_others(Garment garment, std::vector<std::uint8_t> material_of, std::vector<Material> others) {
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
  garment.material_of = std::move(material_of);
  garment.others = std::move(others);
  garment.masses_kg = lumped_masses(garment);
  return garment;
}

double least_density_kg_per_m2(const Garment& garment) {
  double least = garment.material.areal_density_kg_per_m2;
  for (const Material& other : garment.others) least = std::min(least, other.areal_density_kg_per_m2);
  return least;
}

}  // namespace taut::sim
