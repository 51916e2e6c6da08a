#include "app/figures/experiments/drape_test.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/base/interruption.hpp"
#include "renderer/light/surface_buffers.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

/// The shadow is counted in squares of this side.
constexpr double square_m = 2.5e-4;
constexpr int side_squares = 1280;
/// The outline is taken in this many directions, and evened out over this many to each side.
constexpr int direction_count = 720;
constexpr int evened_directions = 12;
/// A fold stands out from the dents beside it by at least this.
constexpr double least_fold_m = 0.003;
/// A disc that still moves after this many frames is taken as it is.
constexpr int most_frames = 600;
constexpr double air_drag_per_s = 6.0;
/// The cloth gets its weight little by little, as the instrument's plate is lowered: dropped at once it folds
/// more often than at rest.
constexpr double lowered_in_s = 3.0;

std::vector<char> shadow_squares(std::span<const sim::Triangle> triangles,
                                 std::span<const sim::Vec3> positions_m) {
  std::vector<char> squares(static_cast<std::size_t>(side_squares) * side_squares, 0);
  const auto place = [&](sim::Index v) {
    return glm::vec3(positions_m[v].x / square_m + 0.5 * side_squares,
                     positions_m[v].z / square_m + 0.5 * side_squares, 0.0);
  };
  for (const sim::Triangle& t : triangles) {
    renderer::rasterise_triangle(place(t[0]), place(t[1]), place(t[2]), side_squares,
                                 [&](const renderer::TriangleSpan& span) {
                                   const auto row = squares.begin() + span.row * side_squares;
                                   std::fill(row + span.first, row + span.last + 1, 1);
                                 });
  }
  return squares;
}

/// How far the shadow reaches in each direction, in m.
std::vector<double> outline_m(const std::vector<char>& squares) {
  std::vector<double> radii_m;
  for (int k = 0; k < direction_count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / direction_count;
    double radius = 0.5 * side_squares - 1.0;
    const auto is_lit = [&] {
      const int column = static_cast<int>(0.5 * side_squares + radius * std::cos(angle));
      const int row = static_cast<int>(0.5 * side_squares + radius * std::sin(angle));
      return squares[static_cast<std::size_t>(row * side_squares + column)] == 0;
    };
    while (radius > 0.0 && is_lit()) {
      radius -= 0.5;
    }
    radii_m.push_back(radius * square_m);
  }
  return radii_m;
}

std::vector<double> evened_out(const std::vector<double>& around) {
  const auto count = static_cast<int>(around.size());
  std::vector<double> means;
  for (int k = 0; k < count; ++k) {
    double sum = 0.0;
    for (int d = -evened_directions; d <= evened_directions; ++d) {
      sum += around[static_cast<std::size_t>((k + d + count) % count)];
    }
    means.push_back(sum / (2 * evened_directions + 1));
  }
  return means;
}

/// Counts how often the outline rises from a dent to a fold, going around once.
int fold_count(const std::vector<double>& radii_m) {
  const auto lowest = std::min_element(radii_m.begin(), radii_m.end());
  std::vector<double> around = radii_m;
  std::rotate(around.begin(), around.begin() + (lowest - radii_m.begin()), around.end());
  int folds = 0;
  bool rises = false;
  double turned_m = around.front();
  for (const double radius_m : around) {
    turned_m = rises ? std::max(turned_m, radius_m) : std::min(turned_m, radius_m);
    if (rises ? radius_m < turned_m - least_fold_m : radius_m > turned_m + least_fold_m) {
      folds += rises ? 0 : 1;
      rises = !rises;
      turned_m = radius_m;
    }
  }
  return folds;
}

sim::SimulationSettings drape_settings() {
  sim::SimulationSettings settings;
  settings.solver.method = sim::BoundedSettings{.max_stretch = 0.01};
  return settings;
}

}  // namespace

DrapeShadow drape_shadow(std::span<const sim::Triangle> triangles, std::span<const sim::Vec3> positions_m) {
  const std::vector<char> squares = shadow_squares(triangles, positions_m);
  const double shadow_m2 =
      square_m * square_m * static_cast<double>(std::count(squares.begin(), squares.end(), 1));
  const double clamped_m2 = std::numbers::pi * clamped_radius_m * clamped_radius_m;
  const double flat_m2 = std::numbers::pi * draped_radius_m * draped_radius_m;
  return {(shadow_m2 - clamped_m2) / (flat_m2 - clamped_m2), fold_count(evened_out(outline_m(squares)))};
}

DrapeRun run_drape(const sim::Material& fabric, const DiscMesh& mesh,
                   const ProgressCallback& report_progress) {
  DrapeRun run;
  run.garment = sim::share(sim::make_garment(make_disc(clamped_radius_m, draped_radius_m, mesh), {}, fabric));
  const std::vector<sim::Vec3>& flat_m = run.garment->mesh.positions;
  for (sim::Index v = 0; v < flat_m.size(); ++v) {
    if (glm::length(flat_m[v]) < clamped_radius_m + 1e-6) {
      run.pins.push_back(v);
    }
  }
  sim::Surroundings air;
  air.forces.air_drag_per_s = air_drag_per_s;
  air.forces.gravity_path = {{0.0, -air.forces.gravity_m_per_s2}, {lowered_in_s, sim::Vec3(0.0)}};
  sim::Simulation simulation(run.garment, run.pins, drape_settings(), air);
  while (run.frames < most_frames && !simulation.state().asleep) {
    report_progress(static_cast<double>(run.frames) / most_frames);
    simulation.advance_frame(throw_if_interrupted);
    ++run.frames;
  }
  run.at_rest = simulation.state().asleep;
  run.positions_m = simulation.state().current;
  run.shadow = drape_shadow(run.garment->mesh.triangles, run.positions_m);
  run.max_stretch = sim::measure_surface_stretch(*run.garment, run.positions_m).max;
  return run;
}

}  // namespace taut::app
