#include "sim/pins.hpp"

namespace taut::sim {

Pins make_pins(const Garment& garment, std::vector<Index> vertices) {
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const std::size_t count = garment.mesh.positions.size();
  if (!vertices.empty() && vertices.back() >= count) {
    throw std::invalid_argument("pin " + std::to_string(vertices.back()) + " is no vertex; there are " +
                                std::to_string(count));
  }
  std::vector<double> inverse_masses_per_kg;
  inverse_masses_per_kg.reserve(count);
  for (const double mass_kg : garment.masses_kg) inverse_masses_per_kg.push_back(1.0 / mass_kg);
  for (const Index pin : vertices) inverse_masses_per_kg[pin] = 0.0;
  return {std::move(vertices), std::move(inverse_masses_per_kg)};
}

}  // namespace taut::sim
