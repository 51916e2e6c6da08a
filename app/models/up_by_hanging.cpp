#include "app/models/up_by_hanging.hpp"

#include <glm/geometric.hpp>
#include <stdexcept>

#include "app/models/hanging.hpp"
#include "app/models/placement.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

constexpr int frames = 60;  // of 1/60 s
/// Share of the other way's movement below which a way up is the better one.
constexpr double clearly_less = 0.7;

/// The mean distance in m by which the cloth moves when it is hung with this axis up. Empty if it cannot be.
std::optional<double> moved_when_hung(const sim::Mesh& model_m, ModelAxis up) {
  sim::Mesh mesh = upright(model_m, up);
  const std::vector<sim::Vec3> start_m = mesh.positions;
  std::vector<sim::Index> pins = hang(mesh, sim::make_adjacency(mesh)).pins;
  if (pins.empty()) {
    return std::nullopt;
  }
  sim::SimulationSettings settings;
  settings.solver.method = sim::BoundedSettings{.contact = false};
  try {
    sim::Simulation simulation(sim::share(sim::make_garment(std::move(mesh), {})), std::move(pins), settings, {});
    for (int frame = 0; frame < frames; ++frame) {
      simulation.advance_frame();
    }
    const std::vector<double>& masses_kg = simulation.garment().masses_kg;
    double sum_kg_m = 0.0, all_kg = 0.0;
    for (std::size_t v = 0; v < start_m.size(); ++v) {
      sum_kg_m += masses_kg[v] * glm::distance(simulation.state().current[v], start_m[v]);
      all_kg += masses_kg[v];
    }
    return sum_kg_m / all_kg;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<ModelAxis> up_by_hanging(const sim::Mesh& model_m) {
  const std::optional<double> y_m = moved_when_hung(model_m, ModelAxis::y);
  const std::optional<double> z_m = moved_when_hung(model_m, ModelAxis::z);
  if (!y_m || !z_m) {
    return std::nullopt;
  }
  if (*z_m < clearly_less * *y_m) {
    return ModelAxis::z;
  }
  return *y_m < clearly_less * *z_m ? std::optional(ModelAxis::y) : std::nullopt;
}

}  // namespace taut::app
