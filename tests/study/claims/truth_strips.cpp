#include "tests/study/claims/truth_setups.hpp"

namespace taut::app::truth {
namespace {

/// Measures a strip of 10 cm, clamped level, for weight times length^3 over rigidity.
TruthPoint droop_strip(const Size& size, double weight_over_rigidity, double physics) {
  constexpr double length_m = 0.1, width_m = 0.03;
  constexpr Index clamped_rows = 3;
  Material material;
  material.areal_density_kg_per_m2 = 0.25;
  material.bending_rigidity_n_m =
      physics * material.areal_density_kg_per_m2 * gravity_m_per_s2 * std::pow(length_m, 3) / weight_over_rigidity;
  const double edge_m = length_m / (size.along - 1);
  const Index rows = size.along + clamped_rows - 1;
  sim::Mesh mesh = rectangle({size.across, rows}, width_m, edge_m * (rows - 1), sim::GridPlane::horizontal);
  std::vector<Index> clamped = vertices_from(0, std::size_t{size.across} * clamped_rows);
  const Vec3 clamp_m = mesh.positions[clamped.back()];
  Surroundings air = in_vacuum();
  air.forces.air_drag_per_s = 3.0;
  sim::Simulation simulation = begin(std::move(mesh), material, std::move(clamped), air);
  advance(simulation, 300);
  const Vec3 end_m = simulation.state().current.back();
  return {"strip", weight_over_rigidity, (clamp_m.y - end_m.y) / (end_m.z - clamp_m.z),
          droop_of_elastica(weight_over_rigidity)};
}

/// Returns a strip of equilateral triangles in the plane z = 0, with rows across it from x = 0. It bends alike in all
/// directions.
sim::Mesh even_strip(const Size& size, double width_m, double length_m) {
  sim::Mesh mesh;
  std::vector<Index> firsts;
  for (Index row = 0; row < size.along; ++row) {
    firsts.push_back(static_cast<Index>(mesh.positions.size()));
    for (Index i = 0; i < size.across + row % 2; ++i) {
      const double at = std::clamp(i - 0.5 * (row % 2), 0.0, size.across - 1.0) / (size.across - 1.0);
      mesh.positions.emplace_back(row * length_m / (size.along - 1), (0.5 - at) * width_m, 0.0);
    }
  }
  for (Index row = 0; row + 1 < size.along; ++row) {
    const Index even = firsts[row + row % 2], odd = firsts[row + 1 - row % 2];
    const auto add = [&](Index a, Index b, Index c) {
      mesh.triangles.push_back(row % 2 == 0 ? sim::Triangle{a, b, c} : sim::Triangle{a, c, b});
    };
    for (Index i = 0; i < size.across; ++i) add(odd + i, odd + i + 1, even + i);
    for (Index i = 0; i + 1 < size.across; ++i) add(even + i + 1, even + i, odd + i + 1);
  }
  return mesh;
}

/// Measures the weight at which a strip of 30 cm, clamped upright on its edge, buckles sideways. A 2000th of the weight
/// acts sideways; under a load q the end moves by q / (1 - (q / q_c)^2).
std::vector<TruthPoint> buckle_strip(const Size& size, double width, double physics) {
  constexpr double length_m = 0.3, aside = 0.0005;
  constexpr Index clamped_rows = 3;
  const double published = weight_that_buckles(width);
  Material material;
  material.compression_stiffness_n_per_m = 1e5;
  material.tensile_warp_n_per_m = material.tensile_weft_n_per_m = material.shear_n_per_m = 1500.0;
  material.bending_rigidity_n_m =
      physics * material.areal_density_kg_per_m2 * gravity_m_per_s2 * std::pow(length_m, 3) / published;
  const double row_m = length_m / (size.along - 1);
  sim::Mesh mesh =
      even_strip({size.across, size.along + clamped_rows - 1}, width * length_m, length_m + (clamped_rows - 1) * row_m);
  std::vector<Index> clamped = vertices_from(0, clamped_rows * size.across + clamped_rows / 2);
  Surroundings air = in_vacuum();
  air.forces.air_drag_per_s = 4.5;
  sim::Simulation simulation = begin(std::move(mesh), material, std::move(clamped), air);
  const auto stiffness_under = [&](double load, int frames) {
    air.forces.gravity_m_per_s2 = load * gravity_m_per_s2 * Vec3(0.0, -1.0, aside);
    simulation.set_surroundings(air);
    advance(simulation, frames);
    return load / simulation.state().current.back().z;
  };
  double load = 0.6, critical = 0.0;
  double stiffness = stiffness_under(load, 200);
  for (const int frames : {160, 340}) {
    const double next = critical > 0.0 ? 0.85 * critical : 0.8;
    const double then = stiffness_under(next, frames);
    critical = std::sqrt((stiffness * next * next - then * load * load) / (stiffness - then));
    load = next;
    stiffness = then;
  }
  return {{"strip", width, published * critical, published}};
}

/// Measures Coulomb's coefficient at which the end of a weightless strip slips while its clamp comes down on it. The
/// clamp moves slightly sideways, so that the strip bends to the other side.
std::vector<TruthPoint> slip_strip(const Size& size, double friction, double physics) {
  constexpr double length_m = 0.1, down = 0.4, aside = 0.01, time_s = 8.0;
  constexpr Index clamped_rows = 3;
  Material material;
  material.areal_density_kg_per_m2 = 0.05;
  material.bending_rigidity_n_m = 5e-4;
  material.compression_stiffness_n_per_m = 3000.0;
  const double row_m = length_m / (size.along - 1);
  const double height_m = length_m + (clamped_rows - 1) * row_m;
  sim::Mesh mesh = rectangle({size.across, size.along + clamped_rows - 1}, 0.03, height_m, sim::GridPlane::vertical);
  for (Vec3& p : mesh.positions) p.y += height_m + 1.01 * material.thickness_m;
  Surroundings air = in_vacuum();
  air.forces.air_drag_per_s = 6.0;
  air.forces.gravity_m_per_s2 = Vec3(0.0);
  air.bodies = {{.name = "ground", .shape = sim::Plane{}, .friction = physics * friction}};
  std::vector<Index> clamped = vertices_from(0, std::size_t{size.across} * clamped_rows);
  air.prescribed_pins = {clamped, std::vector<Vec3>(clamped.size(), -down * length_m * Vec3(0.0, 1.0, aside)), 0.0,
                         time_s};
  sim::Simulation simulation = begin(std::move(mesh), material, std::move(clamped), std::move(air), true);
  const auto has_slipped = [&] { return std::abs(simulation.state().current.back().z) > 0.03 * length_m; };
  while (simulation.state().time_s < time_s && !has_slipped()) simulation.advance_frame();
  const double strain = down * simulation.state().time_s / time_s;
  return {{"strip", strain, friction, friction_that_sticks(strain)}};
}

}  // namespace

std::vector<TruthPoint> run_cantilever(double physics, const ProgressCallback& report) {
  constexpr std::array sizes = {Size{6, 21}, Size{9, 31}, Size{12, 41}};
  return run_all(std::array{physics}, sizes, report, [](double physics_factor, const Size& size) {
    return collect<TruthPoint>(std::array{3.0, 7.0, 16.0, 40.0, 100.0},
                               [&](double load) { return droop_strip(size, load, physics_factor); });
  });
}

std::vector<TruthPoint> run_buckling(double physics, const ProgressCallback& report) {
  struct Widths {
    double width;
    std::array<Size, 3> sizes;
  };
  const std::array<Widths, 5> all = {{{0.25, {{{6, 24}, {7, 29}, {8, 33}}}},
                                      {0.3, {{{8, 28}, {9, 32}, {10, 36}}}},
                                      {0.35, {{{9, 27}, {10, 31}, {11, 32}}}},
                                      {0.4, {{{9, 24}, {10, 27}, {11, 30}}}},
                                      {0.5, {{{10, 22}, {11, 24}, {12, 27}}}}}};
  std::vector<TruthPoint> points;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto run = [&](double width, const Size& size) { return buckle_strip(size, width, physics); };
    std::ranges::move(run_all(std::array{all[i].width}, all[i].sizes, report_part(report, i, all.size()), run),
                      std::back_inserter(points));
  }
  return points;
}

std::vector<TruthPoint> run_slip(double physics, const ProgressCallback& report) {
  return run_all(std::array{0.18, 0.22, 0.26, 0.3, 0.34}, std::array{Size{3, 15}, Size{3, 18}, Size{3, 22}}, report,
                 [&](double friction, const Size& size) { return slip_strip(size, friction, physics); });
}

}  // namespace taut::app::truth
