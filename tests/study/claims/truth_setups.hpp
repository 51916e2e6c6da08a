#pragma once

#include "app/base/words.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"
#include "tests/study/claims/truth.hpp"

/// Functions that the experiments share.
namespace taut::app::truth {

using sim::Index;
using sim::Material;
using sim::Surroundings;
using sim::Vec3;

inline constexpr double gravity_m_per_s2 = 9.81;

struct Size {
  Index across;
  Index along;
};

inline std::string to_name(const Size& size) { return fmt::format("{} x {}", size.across, size.along); }

/// Returns a rectangle that hangs, or lies level with its rows along z.
inline sim::Mesh rectangle(const Size& size, double width_m, double length_m, sim::GridPlane plane) {
  sim::GridSettings grid;
  grid.columns = size.across;
  grid.rows = size.along;
  grid.width_m = width_m;
  grid.height_m = length_m;
  grid.plane = plane;
  return sim::make_grid(grid);
}

inline std::vector<Index> vertices_from(std::size_t first, std::size_t count) {
  std::vector<Index> vertices(count);
  std::iota(vertices.begin(), vertices.end(), static_cast<Index>(first));
  return vertices;
}

inline Surroundings in_vacuum() {
  Surroundings surroundings;
  surroundings.forces.air_drag_per_s = 0.0;
  surroundings.forces.wind.pressure_coefficient = 0.0;
  surroundings.forces.wind.friction_coefficient = 0.0;
  return surroundings;
}

inline sim::Simulation begin(std::shared_ptr<const sim::Garment> garment, std::vector<Index> pins,
                             Surroundings surroundings, double max_stretch, bool contact,
                             std::optional<std::vector<Vec3>> start_m = {}) {
  sim::SimulationSettings settings;
  settings.rest_settings.speed_m_per_s = 0.0;
  settings.solver.method = sim::BoundedSettings{.max_stretch = max_stretch, .contact = contact, .threads = 1};
  return {std::move(garment), std::move(pins), settings, std::move(surroundings), std::move(start_m)};
}

inline sim::Simulation begin(sim::Mesh mesh, const Material& material, std::vector<Index> pins,
                             Surroundings surroundings, bool contact = false,
                             std::optional<std::vector<Vec3>> start_m = {}) {
  return begin(sim::share(sim::make_garment(std::move(mesh), {}, material)), std::move(pins), std::move(surroundings),
               0.01, contact, std::move(start_m));
}

inline void advance(sim::Simulation& simulation, int frames) {
  for (int frame = 0; frame < frames; ++frame) simulation.advance_frame();
}

/// Calls run(case, mesh) for each case on each mesh, names the meshes in its points, and reports the progress.
template <class Cases, class Meshes, class Run>
std::vector<TruthPoint> run_all(const Cases& cases, const Meshes& meshes, const ProgressCallback& report,
                                const Run& run) {
  std::vector<TruthPoint> points;
  double done = 0.0;
  for (const auto& one : cases) {
    for (const auto& mesh : meshes) {
      for (TruthPoint& point : run(one, mesh)) points.emplace_back(std::move(point)).mesh = to_name(mesh);
      report(++done / static_cast<double>(std::size(cases) * std::size(meshes)));
    }
  }
  return points;
}

using Runs = std::vector<TruthPoint>(double physics, const ProgressCallback& report);
// Experiments of truth_strips.cpp.
Runs run_cantilever, run_buckling, run_slip;
// Experiments of truth_wind.cpp and truth_flutter.cpp.
Runs run_hanging, run_flag, run_flutter, run_onset, run_line, run_plate;

}  // namespace taut::app::truth
