#include "app/models/up_by_hanging.hpp"

#include <glm/geometric.hpp>
#include <stdexcept>

#include "app/models/hanging.hpp"
#include "app/models/placement.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/topology.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

constexpr int frames = 60;  // of 1/60 s
/// Share of the other way's sagging below which a way up is the better one.
constexpr double clearly_less = 0.7;
/// Thickness of a flat pattern, of its length.
constexpr double flat = 0.001;
/// Height of the middle of its area above which cloth that lay flat has its wider end at the top.
constexpr double middle_height = 0.52;

/// How much the cloth sags when it is hung with this axis up: the mean distance by which it moves, over the
/// square of its height then, as what lies hardly moves either. Empty if it cannot be hung.
std::optional<double> sagging_when_hung(const sim::Mesh& model_m, ModelAxis up) {
  sim::Mesh mesh = upright(model_m, up);
  const std::vector<sim::Vec3> start_m = mesh.positions;
  std::vector<sim::Index> pins = hang(mesh, sim::make_adjacency(mesh)).pins;
  if (pins.empty()) {
    return std::nullopt;
  }
  sim::SimulationSettings settings;
  settings.solver.method = sim::BoundedSettings{.contact = false};
  try {
    sim::Simulation simulation(sim::share(sim::make_garment(std::move(mesh), {})), std::move(pins), settings,
                               {});
    for (int frame = 0; frame < frames; ++frame) {
      simulation.advance_frame();
    }
    const std::vector<double>& masses_kg = simulation.garment().masses_kg;
    double sum_kg_m = 0.0, all_kg = 0.0;
    for (std::size_t v = 0; v < start_m.size(); ++v) {
      sum_kg_m += masses_kg[v] * glm::distance(simulation.state().current[v], start_m[v]);
      all_kg += masses_kg[v];
    }
    const double height_m = sim::extent_of(simulation.state().current).size().y;
    return sum_kg_m / all_kg / (height_m * height_m);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

/// Whether the middle of its area is nearer to its lower end.
bool is_wider_below(const sim::Mesh& mesh) {
  double moment = 0.0, all = 0.0;
  for (const sim::Triangle& t : mesh.triangles) {
    const double area = glm::length(sim::doubled_area_vector(mesh.positions, t));
    moment += area * (mesh.positions[t[0]].y + mesh.positions[t[1]].y + mesh.positions[t[2]].y) / 3.0;
    all += area;
  }
  const sim::Extent box = sim::extent_of(mesh.positions);
  return moment / all <= box.lower.y + middle_height * box.size().y;
}

}  // namespace

std::optional<ModelAxis> up_by_hanging(const sim::Mesh& model_m) {
  const std::optional<double> y = sagging_when_hung(model_m, ModelAxis::y);
  const std::optional<double> z = sagging_when_hung(model_m, ModelAxis::z);
  if (!y || !z) {
    return std::nullopt;
  }
  if (*z < clearly_less * *y) {
    const sim::Vec3 size = sim::extent_of(model_m.positions).size();
    const bool is_lying = size.y < flat * size.z;
    return is_lying && !is_wider_below(upright(model_m, ModelAxis::z)) ? ModelAxis::minus_z : ModelAxis::z;
  }
  return *y < clearly_less * *z ? std::optional(ModelAxis::y) : std::nullopt;
}

}  // namespace taut::app
