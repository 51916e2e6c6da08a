// The law of cloth in its plane: strain is tension over stiffness.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "sim/measures.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::sim {
namespace {

constexpr double width_m = 0.1;

struct Strip {
  Index columns = 6;
  Index rows = 21;
  double warp_n_per_m = 500.0;
  double weft_n_per_m = 500.0;
  double shear_n_per_m = 60.0;
  double warp_angle = 0.0;  ///< angle in rad of the warp to the strip's length
  double warp_limit = 10.0;
};

Garment make_strip(const Strip& strip) {
  GridSettings grid;
  grid.columns = strip.columns;
  grid.rows = strip.rows;
  grid.width_m = width_m;
  grid.height_m = 0.4;
  Material material;
  material.tensile_warp_n_per_m = strip.warp_n_per_m;
  material.tensile_weft_n_per_m = strip.weft_n_per_m;
  material.shear_n_per_m = strip.shear_n_per_m;
  material.warp_limit = strip.warp_limit;
  Garment garment = make_garment(make_grid(grid), {}, material);
  const Vec3 warp(std::sin(strip.warp_angle), std::cos(strip.warp_angle), 0.0);
  for (const Triangle& t : garment.mesh.triangles) {
    const std::array<Vec3, 3> at = corner_positions(t, garment.mesh.positions);
    const Vec3 first = glm::normalize(at[1] - at[0]);
    const Vec3 second = glm::cross(glm::normalize(glm::cross(first, at[2] - at[0])), first);
    garment.warps.emplace_back(glm::dot(warp, first), glm::dot(warp, second));
  }
  return garment;
}

struct AtRest {
  double strain = 0.0;  ///< strain of the middle half of the strip
  double speed_m_per_s = 0.0;
};

/// Pulls at the lower edge of a strip that hangs by its upper one.
AtRest pull(const Strip& strip, double load_n_per_m, double frame_rate_hz = 60.0) {
  const std::shared_ptr<const Garment> garment = share(make_strip(strip));
  SimulationSettings settings;
  settings.frame_rate_hz = frame_rate_hz;
  settings.rest_settings.speed_m_per_s = 0.0;  // a light load stretches by a millimetre, and slowly
  BoundedSettings bounded;
  bounded.contact = false;
  bounded.max_stretch = 0.2;
  settings.solver.method = bounded;
  Surroundings surroundings;
  surroundings.forces.gravity_m_per_s2 = Vec3(0.0);
  surroundings.forces.air_drag_per_s = 2.0;
  std::vector<Index> pins;
  for (Index c = 0; c < strip.columns; ++c) {
    const double share = (c == 0 || c + 1 == strip.columns ? 0.5 : 1.0) / (strip.columns - 1);
    surroundings.forces.artificial_forces.push_back(
        {(strip.rows - 1) * strip.columns + c, Vec3(0.0, -load_n_per_m * width_m * share, 0.0)});
    pins.push_back(c);
  }
  Simulation simulation(garment, pins, settings, surroundings);
  for (int frame = 0; frame < 3.0 * frame_rate_hz; ++frame) {
    simulation.advance_frame();
  }
  const auto length_m = [&](const std::vector<Vec3>& positions) {
    double sum_m = 0.0;
    for (Index c = 0; c < strip.columns; ++c) {
      sum_m += positions[strip.rows / 4 * strip.columns + c].y -
               positions[(strip.rows - 1 - strip.rows / 4) * strip.columns + c].y;
    }
    return sum_m;
  };
  const ShapeChange change = simulation.change();
  return {length_m(simulation.state().current) / length_m(garment->mesh.positions) - 1.0,
          measure_convergence(change).rms_m / change.time_s};
}

TEST(Elasticity, AStripStretchesByLoadOverStiffnessOnAnyMeshAtAnyFrameRate) {
  for (const auto& [columns, rows] : {std::pair<Index, Index>{5, 17}, {6, 21}, {9, 33}}) {
    Strip strip;
    strip.columns = columns;
    strip.rows = rows;
    for (const double load : {1.0, 5.0, 20.0}) {
      for (const double rate_hz : {24.0, 60.0, 240.0}) {
        const double expected = load / strip.warp_n_per_m;
        EXPECT_NEAR(pull(strip, load, rate_hz).strain, expected, 0.03 * expected)
            << columns << " columns, " << load << " N/m, " << rate_hz << " Hz";
      }
    }
  }
}

TEST(Elasticity, WarpWeftAndBiasEachHaveTheirStiffness) {
  Strip strip;
  strip.warp_n_per_m = 2000.0;
  strip.warp_angle = std::acos(0.0);
  EXPECT_NEAR(pull(strip, 5.0).strain, 5.0 / 500.0, 0.03 * 5.0 / 500.0);
  strip.warp_angle = std::acos(0.0) / 2.0;
  const double bias_m_per_n = (1.0 / 2000.0 + 1.0 / 500.0 + 1.0 / 60.0) / 4.0;
  EXPECT_NEAR(pull(strip, 5.0).strain, 5.0 * bias_m_per_n, 0.04 * 5.0 * bias_m_per_n);
}

TEST(Elasticity, ThreadsLock) {
  Strip strip;
  strip.warp_limit = 0.005;
  EXPECT_NEAR(pull(strip, 10.0).strain, 0.005, 0.001);
}

TEST(Elasticity, ClothUnderLoadComesToRest) {
  for (const double rate_hz : {24.0, 60.0, 240.0}) {
    EXPECT_LT(pull({}, 5.0, rate_hz).speed_m_per_s, 2e-4) << rate_hz;
  }
}

// Time steps would otherwise take the cloth back to its rest length at once, at metres a second.
TEST(Elasticity, ClothThatBeginsStretchedBeginsUnderTension) {
  const Strip strip;
  const std::shared_ptr<const Garment> garment = share(make_strip(strip));
  SimulationSettings settings;
  settings.solver.method = BoundedSettings{.max_stretch = 0.2, .contact = false};
  Surroundings surroundings;
  surroundings.forces.gravity_m_per_s2 = Vec3(0.0);
  std::vector<Index> pins(strip.columns);
  std::iota(pins.begin(), pins.end(), Index{0});
  const double top_m = garment->mesh.positions.front().y;
  std::vector<Vec3> start = garment->mesh.positions;
  constexpr double strain = 0.1;
  for (Vec3& position : start) position.y = top_m + (1.0 + strain) * (position.y - top_m);
  Simulation simulation(garment, pins, settings, surroundings, start);
  const double stretched_m = strain * (top_m - garment->mesh.positions.back().y);
  const auto contracted = [&] { return (simulation.state().current.back().y - start.back().y) / stretched_m; };
  simulation.advance_frame();
  EXPECT_LT(contracted(), 0.3);
  for (int frame = 1; frame < 60; ++frame) simulation.advance_frame();
  EXPECT_GT(contracted(), 0.5) << "nothing holds it";
}

TEST(Elasticity, GoesOnFromACheckpointWithTheSameBits) {
  const std::shared_ptr<const Garment> garment = share(make_strip({}));
  SimulationSettings settings;
  settings.solver.method = BoundedSettings{};
  const auto hung = [&] { return Simulation(garment, {0, 1, 2, 3, 4, 5}, settings, {}); };
  Simulation simulation = hung();
  for (int frame = 0; frame < 20; ++frame) {
    simulation.advance_frame();
  }
  Simulation resumed = hung();
  resumed.restore(simulation.save());
  for (int frame = 0; frame < 20; ++frame) {
    simulation.advance_frame();
    resumed.advance_frame();
  }
  EXPECT_EQ(resumed.state().current, simulation.state().current);
}

TEST(Elasticity, ACheckpointServesClothOfAnotherLaw) {
  const auto hung = [](const Strip& strip) {
    SimulationSettings settings;
    settings.solver.method = BoundedSettings{};
    return Simulation(share(make_strip(strip)), {0, 1, 2, 3, 4, 5}, settings, {});
  };
  Simulation with = hung({});
  Simulation without = hung({.warp_n_per_m = 0.0, .weft_n_per_m = 0.0, .shear_n_per_m = 0.0});
  with.advance_frame();
  without.restore(with.save());
  without.advance_frame();
  with.restore(without.save());
  EXPECT_EQ(with.state().current, without.state().current);
  with.advance_frame();
}

TEST(Elasticity, AllStiffnessesAreGivenOrNone) {
  Strip strip;
  strip.shear_n_per_m = 0.0;
  EXPECT_THROW(make_strip(strip), std::invalid_argument);
  strip.warp_n_per_m = strip.weft_n_per_m = 0.0;
  EXPECT_NO_THROW(make_strip(strip));
}

}  // namespace
}  // namespace taut::sim
