#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numbers>

#include "sheets.hpp"
#include "sim/measures.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"
#include "vacuum.hpp"

namespace taut::sim {
namespace {

SimulationSettings settings_with(double max_strain) {
  SimulationSettings settings;
  settings.solver.method = FastProjectionSettings{.max_strain = max_strain};
  return settings;
}

double max_strain(const Garment& garment, const State& state) {
  const Stretch stretch = measure_stretch(garment.springs, state.current);
  return std::max(stretch.max, stretch.max_compression);
}

// One edge: with C = L^2 / l - l and dC/dL = 2 L / l the length changes by -C / (dC/dL).
TEST(FastProjection, ProjectsOneEdgeByNewtonsStep) {
  const std::vector<Edge> edges = {{0, 1}};
  const std::vector<double> rest_m = {1.0};
  LengthSystem system(edges, rest_m, {{}, {1.0, 1.0 / 3.0}});
  std::vector<Vec3> positions = {{0, 0, 0}, {0, 1.2, 0}};
  EXPECT_NEAR(system.find_max_strain(positions), 0.2, 1e-15);
  ASSERT_TRUE(system.project(positions));
  const double change_m = (1.2 * 1.2 - 1.0) / 2.4;
  EXPECT_NEAR(positions[0].y, 0.75 * change_m, 1e-6) << "a third of the other's mass";
  EXPECT_NEAR(positions[1].y, 1.2 - 0.25 * change_m, 1e-6);
}

// Many edges are corrected at once, to second order.
TEST(FastProjection, ConvergesAsNewtonsMethodAndKeepsTheMomentum) {
  const Garment garment = make_garment(make_grid({.columns = 4, .rows = 4}));
  const std::size_t count = garment.springs.structural_count;
  LengthSystem system(std::span(garment.springs.ends).first(count),
                      std::span(garment.springs.rest_lengths_m).first(count), make_pins(garment, {}));
  std::vector<Vec3> positions = garment.mesh.positions;
  Vec3 momentum(0.0);
  for (Index v = 0; v < positions.size(); ++v) {
    positions[v] *= 1.1;
    positions[v].z += 0.03 * (v % 3);
    momentum += garment.masses_kg[v] * positions[v];
  }
  std::vector<double> strains = {system.find_max_strain(positions)};
  for (int projection = 0; projection < 4; ++projection) {
    ASSERT_TRUE(system.project(positions));
    strains.push_back(system.find_max_strain(positions));
  }
  EXPECT_LT(strains[2], 0.2 * strains[1]);
  EXPECT_LT(strains[4], 1e-6) << strains[1] << ' ' << strains[2] << ' ' << strains[3];
  for (Index v = 0; v < positions.size(); ++v) {
    momentum -= garment.masses_kg[v] * positions[v];
  }
  EXPECT_NEAR(glm::length(momentum), 0.0, 1e-12);
}

// Two masses hang below two pins.
TEST(FastProjection, AStripSwingsWithThePeriodOfItsLength) {
  const double length_m = 0.7;
  const double amplitude_rad = 0.2;
  const Garment strip =
      make_garment(make_grid({.columns = 2, .rows = 2, .width_m = 0.3, .height_m = length_m}));
  std::vector<Vec3> start = strip.mesh.positions;
  for (Vec3& p : start) {
    p = {p.x, p.y * std::cos(amplitude_rad), p.y * std::sin(amplitude_rad)};
  }
  SimulationSettings settings = settings_with(1e-6);
  settings.frame_rate_hz = 500.0;
  Simulation simulation(share(strip), {0, 1}, settings, vacuum(9.81), start);
  std::vector<double> passages_s;
  while (passages_s.size() < 2 && simulation.state().time_s < 5.0) {
    const double before = simulation.state().current[2].z;
    simulation.advance_frame();
    const double now = simulation.state().current[2].z;
    if (before < 0.0 && now >= 0.0) {
      passages_s.push_back(simulation.state().time_s - simulation.frame_time_s() * now / (now - before));
    }
    EXPECT_LT(max_strain(strip, simulation.state()), 1e-6);
    EXPECT_EQ(simulation.state().current[0], strip.mesh.positions[0]) << "pinned";
  }
  ASSERT_EQ(passages_s.size(), 2U);
  const double a2 = amplitude_rad * amplitude_rad;
  const double period_s = 2.0 * std::numbers::pi * std::sqrt(length_m / 9.81) * (1.0 + a2 / 16.0);
  EXPECT_NEAR(passages_s[1] - passages_s[0], period_s, 2e-3 * period_s);
}

TEST(FastProjection, AGridKeepsItsLengthsInWindAndIsSheared) {
  const Garment cloth = make_garment(make_grid({}));
  Surroundings windy;
  windy.forces.wind.speed_m_per_s = 5.0;
  Simulation simulation(share(cloth), {0, 8}, settings_with(1e-3), windy);
  for (int frame = 0; frame < 60; ++frame) {
    simulation.advance_frame();
    ASSERT_LT(max_strain(cloth, simulation.state()), 1e-3) << frame;
  }
  double longest = 0.0;
  const Springs& springs = cloth.springs;
  for (std::size_t s = springs.begin_index(SpringKind::shear); s < springs.end_index(SpringKind::shear); ++s) {
    const auto& now = simulation.state().current;
    const double length_m = glm::distance(now[springs.ends[s][0]], now[springs.ends[s][1]]);
    longest = std::max(longest, length_m / springs.rest_lengths_m[s]);
  }
  EXPECT_GT(longest, 1.002) << "diagonals are soft";
}

// The system has as many lengths as coordinates. It is singular for a flat sheet and has to be solved nevertheless.
TEST(FastProjection, TrianglesThatLockAreSolved) {
  const Garment sheet = make_garment(irregular_sheet(12, 1.0));
  Mesh bent = sheet.mesh;
  for (Vec3& p : bent.positions) {
    p.z = 0.1 * p.x * p.x;
  }
  for (const Garment& garment : {sheet, make_garment(bent)}) {
    Simulation simulation(share(garment), {0, 11}, settings_with(0.01), {});
    for (int frame = 0; frame < 10; ++frame) {
      simulation.advance_frame();
      EXPECT_LT(max_strain(garment, simulation.state()), 0.05) << frame;
    }
  }
}

// Two edges that are too long between two pins on a line: neither can be kept.
TEST(FastProjection, LengthsThatContradictEachOtherAreSolvedToo) {
  Garment chain;
  chain.mesh.positions = {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}};
  chain.masses_kg = {1.0, 1.0, 1.0};
  const std::vector<Edge> edges = {{0, 1}, {1, 2}};
  LengthSystem system(edges, std::vector<double>{0.4, 0.4}, make_pins(chain, {0, 2}));
  std::vector<Vec3> positions = chain.mesh.positions;
  ASSERT_TRUE(system.project(positions));
  EXPECT_NEAR(glm::distance(positions[1], chain.mesh.positions[1]), 0.0, 1e-6);
  EXPECT_EQ(positions[0], chain.mesh.positions[0]);
}

TEST(FastProjection, NothingToProjectIsNoError) {
  const Garment cloth = make_garment(make_grid({.columns = 2, .rows = 2}));
  Simulation simulation(share(cloth), {0, 1, 2, 3}, settings_with(0.01), {});
  simulation.advance_frame();
  EXPECT_EQ(simulation.state().current, cloth.mesh.positions);
}

}  // namespace
}  // namespace taut::sim
