#include "sim/garment.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace taut::sim {
namespace {

double area(const Mesh& mesh, std::size_t triangle) {
  return glm::length(doubled_area_vector(mesh.positions, mesh.triangles[triangle])) / 2.0;
}

/// Of the mean over all vertices. A vertex with next to no mass between heavy ones passes on next to nothing
/// of what a correction of its springs should move, which no number of sweeps makes good.
constexpr double least_mass = 0.05;

void raise_to_least_mass(std::vector<double>& masses) {
  const double mean = std::accumulate(masses.begin(), masses.end(), 0.0) / static_cast<double>(masses.size());
  for (double& mass : masses) {
    mass = std::max(mass, least_mass * mean);
  }
}

std::vector<double> lumped_masses(const Mesh& mesh, double density) {
  std::vector<double> masses(mesh.positions.size(), 0.0);
  // Grid cells share their mass among four corners: by triangles, the arbitrary choice of the diagonal
  // would make two of them twice as heavy.
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    for (const Index v : mesh.quads[q]) {
      masses[v] += density * (area(mesh, 2 * q) + area(mesh, 2 * q + 1)) / 4.0;
    }
  }
  for (std::size_t t = 2 * mesh.quads.size(); t < mesh.triangles.size(); ++t) {
    for (const Index v : mesh.triangles[t]) {
      masses[v] += density * area(mesh, t) / 3.0;
    }
  }
  raise_to_least_mass(masses);
  return masses;
}

}  // namespace

void hold_by(Garment& garment, std::vector<Index> pins) {
  std::sort(pins.begin(), pins.end());
  pins.erase(std::unique(pins.begin(), pins.end()), pins.end());
  if (!pins.empty() && pins.back() >= garment.mesh.positions.size()) {
    throw std::invalid_argument("pin " + std::to_string(pins.back()) + " is no vertex; there are " +
                                std::to_string(garment.mesh.positions.size()));
  }
  for (std::size_t v = 0; v < garment.masses_kg.size(); ++v) {
    garment.inverse_masses_per_kg[v] = 1.0 / garment.masses_kg[v];
  }
  for (const Index pin : pins) {
    garment.inverse_masses_per_kg[pin] = 0.0;
  }
  garment.pins = std::move(pins);
}

Garment make_garment(Mesh mesh, const GarmentSettings& settings, std::vector<Index> pins) {
  if (!(settings.areal_density_kg_per_m2 > 0.0)) {
    throw std::invalid_argument("the areal density must be above 0 kg/m2");
  }
  Garment garment;
  garment.mesh = std::move(mesh);
  garment.adjacency = make_adjacency(garment.mesh);
  garment.springs = map_to_springs(garment.mesh, garment.adjacency, settings.mapping);
  garment.areal_density_kg_per_m2 = settings.areal_density_kg_per_m2;
  garment.masses_kg = lumped_masses(garment.mesh, settings.areal_density_kg_per_m2);
  garment.inverse_masses_per_kg.resize(garment.masses_kg.size());
  hold_by(garment, std::move(pins));
  return garment;
}

}  // namespace taut::sim
