// Threads along the cloth from its pins to every vertex.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"
#include "sim/solvers/bounded/kernels/kernels.hpp"
#include "sim/solvers/bounded/step.hpp"

namespace taut::sim {
namespace {

using namespace bounded;

Garment sheet(Index count) {
  GridSettings grid;
  grid.columns = grid.rows = count;
  grid.width_m = grid.height_m = 1.0;
  return make_garment(make_grid(grid));
}

std::vector<Index> top_row(Index count) {
  std::vector<Index> pins(count);
  for (Index column = 0; column < count; ++column) {
    pins[column] = column;
  }
  return pins;
}

TEST(Tethers, TheClothAtRestReachesNone) {
  const Garment garment = sheet(33);
  const Layout layout = make_layout(garment, make_pins(garment, {0, 32}));
  Tethers tethers = make_tethers(garment, layout, 0.0);
  StartRows rest;
  set_start(layout, garment.mesh.positions, rest);
  start_tethers(rest, tethers);
  std::size_t count = 0;
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    const Tether& tether = tethers.lanes[row];
    const Vec3 from_pin_m(tether.start_x, tether.start_y, tether.start_z);
    const Vec3 expected_m = garment.mesh.positions[layout.vertex_indices[row]] -
                            garment.mesh.positions[layout.vertex_indices[tethers.pin[row]]];
    EXPECT_LT(glm::distance(from_pin_m, expected_m), 1e-7);
    EXPECT_GE(tether.squared_length, glm::dot(expected_m, expected_m) * (1.0 - 1e-6));
    count += tether.squared_length < unreachable_squared_m2 ? 1 : 0;
  }
  EXPECT_GT(count, layout.vertex_count() * 9 / 10) << "all but those next to the pins";
}

TEST(Tethers, AreAsLongAsTheBoundAllows) {
  const Garment garment = sheet(9);
  const Layout layout = make_layout(garment, make_pins(garment, {0}));
  const std::size_t last = layout.vertex_count() - 1;
  const double way2 = std::pow(layout.distance_from_pins_m[last], 2);
  EXPECT_NEAR(make_tethers(garment, layout, 0.0).lanes[last].squared_length, way2, 1e-6);
  EXPECT_NEAR(make_tethers(garment, layout, 0.002).lanes[last].squared_length, way2 * 1.002 * 1.002, 1e-6);
  EXPECT_NEAR(make_tethers(garment, layout, 0.3).lanes[last].squared_length, way2 * 1.3 * 1.3, 1e-6);
}

TEST(Tethers, BringVerticesBackAndMoveWithThePins) {
  const Garment garment = sheet(9);
  const Layout layout = make_layout(garment, make_pins(garment, {0}));
  Tethers tethers = make_tethers(garment, layout, 0.0);
  const std::size_t last = layout.vertex_count() - 1;
  const double length_m = std::sqrt(tethers.lanes[last].squared_length);
  const Prediction prediction = {0.0F, 0.0F, {0.5F, 0.0F, 0.0F, 0.0F}};
  const Float4Array accelerations(layout.row_count());
  const auto hung_at = [&](double distance_m) {
    Float4Array current(layout.row_count());
    Float4Array predicted(layout.row_count());
    current[last].x = static_cast<float>(0.5 + distance_m);
    kernels_for(VectorUnit::scalar)
        .predict(0, layout.row_count(), prediction, tethers.lanes.data(), accelerations.data(),
                 current.data(), predicted.data());
    return predicted[last].x - 0.5;
  };
  EXPECT_FLOAT_EQ(static_cast<float>(hung_at(0.99 * length_m)), static_cast<float>(0.99 * length_m));
  EXPECT_NEAR(hung_at(1.02 * length_m), length_m, 5e-4) << "to the second order of the error";
}

// A curtain, the case that tethers exist for: it is flat and cannot give way sideways, so that it bounces up and down
// within its bound without tethers.
void expect_fewer_steps(BoundKind bound) {
  const Index count = 97;
  const Garment garment = sheet(count);
  int steps[2] = {0, 0};
  for (const bool tethered : {false, true}) {
    SimulationSettings settings;
    settings.solver.method = BoundedSettings{.bound = bound, .contact = false, .tethers = tethered};
    Simulation simulation(share(garment), top_row(count), settings, {});
    for (int frame = 0; frame < 60; ++frame) {
      simulation.advance_frame();
      steps[tethered ? 1 : 0] += simulation.frame_report().substeps;
    }
    const Index hem = count * count - 1 - count / 2;
    const double sag_m = garment.mesh.positions[hem].y - simulation.state().current[hem].y;
    EXPECT_GT(sag_m, tethered ? 0.0 : -0.05) << "of 1 m";
    EXPECT_LT(sag_m, 0.05);
  }
  EXPECT_LT(steps[1], 0.8 * steps[0]);
}

TEST(Tethers, FineClothKeepsItsBoundWithFewerSteps) {
  for (const BoundKind bound : all_bound_kinds) {
    expect_fewer_steps(bound);
  }
}

}  // namespace
}  // namespace taut::sim
