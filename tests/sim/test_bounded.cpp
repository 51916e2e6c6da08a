// The solver that promises a bound on stretch.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sheets.hpp"
#include "sim/measures.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"
#include "sim/solvers/bounded/bending.hpp"
#include "sim/solvers/bounded/flexural.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim {
namespace {

using namespace bounded;

SimulationSettings bounded_by(double max_stretch) {
  SimulationSettings settings;
  settings.solver.method = BoundedSettings{.max_stretch = max_stretch};
  return settings;
}

double largest_stretch(const Garment& garment, std::span<const Vec3> positions) {
  double largest = 0.0;
  for (std::size_t s = 0; s < garment.springs.begin_of(SpringKind::flexural); ++s) {
    const auto [i, j] = garment.springs.ends[s];
    largest =
        std::max(largest, glm::length(positions[i] - positions[j]) / garment.springs.rest_lengths_m[s] - 1.0);
  }
  return largest;
}

Surroundings storm() {
  Surroundings surroundings;
  surroundings.forces.wind.speed_m_per_s = 12.0;
  surroundings.forces.wind.gust_amplitude = 0.5;
  surroundings.forces.wind.gust_turn = 0.3;
  return surroundings;
}

Surroundings shaken() {
  Surroundings surroundings;
  surroundings.pin_motion = {{0.1, 0.0, 0.0}, 1.0};
  return surroundings;
}

TEST(Layout, EveryMovableSpringIsInOneLaneAndColoursShareNoVertex) {
  const Garment garment = make_garment(irregular_sheet(12, 1.0));
  const Pins pins = make_pins(garment, {0, 1, 11});
  const Layout layout = make_layout(garment, pins);
  const SpringLanes& lanes = layout.springs;
  std::vector<int> seen(garment.springs.size(), 0);
  for (const auto [begin, end] : lanes.sweep) {
    std::vector<int> used(layout.row_count(), 0);
    for (std::size_t k = begin * block_size; k < end * block_size; ++k) {
      EXPECT_EQ(used[lanes.row_i(k)]++, 0);
      EXPECT_EQ(used[lanes.row_j(k)]++, 0);
      if (lanes.spring[k] != SpringLanes::no_spring) {
        ++seen[lanes.spring[k]];
        const auto [a, b] = garment.springs.ends[lanes.spring[k]];
        EXPECT_EQ(std::minmax(layout.vertex_of_row[lanes.row_i(k)], layout.vertex_of_row[lanes.row_j(k)]),
                  std::minmax(a, b));
      } else {
        EXPECT_GE(lanes.row_i(k), layout.vertex_count());
      }
    }
  }
  for (std::size_t s = 0; s < garment.springs.begin_of(SpringKind::flexural); ++s) {
    const auto [a, b] = garment.springs.ends[s];
    const bool between_pins = pins.inverse_masses_per_kg[a] + pins.inverse_masses_per_kg[b] == 0.0;
    EXPECT_EQ(seen[s], between_pins ? 0 : 1);
  }
}

TEST(Layout, RowsAreInTheOrderOfTheirDistanceFromThePins) {
  const Garment garment = make_garment(sheet(5, 1.0));
  const Layout layout = make_layout(garment, make_pins(garment, {2}));
  EXPECT_EQ(layout.vertex_of_row[0], 2u);
  EXPECT_TRUE(std::is_sorted(layout.distance_from_pins_m.begin(), layout.distance_from_pins_m.end()));
  EXPECT_NEAR(layout.distance_from_pins_m.back(), std::hypot(0.5, 1.0), 1e-12);
}

TEST(Layout, TheStartOfAFrameIsKeptToTheDigitsOfTwoSinglePrecisionNumbers) {
  const Garment garment = make_garment(sheet(9, 1.0));
  const Layout layout = make_layout(garment, make_pins(garment, {0}));
  std::vector<Vec3> positions_m = garment.mesh.positions;
  for (std::size_t v = 0; v < positions_m.size(); ++v) {
    positions_m[v] += 1.0 / (static_cast<double>(v) + 3.0);
  }
  StartRows start;
  set_start(layout, positions_m, start);
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    const Vec3 from_origin_m = positions_m[layout.vertex_of_row[row]] - positions_m[layout.vertex_of_row[0]];
    EXPECT_LT(glm::distance(vector_of(start.high[row]) + vector_of(start.low[row]), from_origin_m), 1e-14)
        << row;
  }
}

TEST(Flexural, FlatShapesAreNotBent) {
  for (const Mesh& mesh : {sheet(7, 1.0), irregular_sheet(12, 1.0)}) {
    const Garment garment = make_garment(mesh);
    const auto elements = flexural_elements(garment);
    EXPECT_GT(20 * elements.size(), 19 * garment.springs.count(SpringKind::flexural));
    for (const FlexuralElement& e : elements) {
      Vec3 deflection(0.0);
      for (std::size_t k = 0; k < 4; ++k) {
        deflection += e.weights[k] * mesh.positions[e.vertices[k]];
      }
      EXPECT_LT(glm::length(deflection), 1e-12);
    }
  }
}

constexpr double rolled_curvature_per_m = 0.5;

std::vector<Vec3> rolled(const Mesh& flat, double axis_angle_rad) {
  const double curvature_per_m = rolled_curvature_per_m;
  const Vec3 along(std::cos(axis_angle_rad), std::sin(axis_angle_rad), 0.0);
  const Vec3 across(-along.y, along.x, 0.0);
  std::vector<Vec3> positions;
  for (const Vec3& p : flat.positions) {
    const double angle = glm::dot(p, across) * curvature_per_m;
    positions.push_back(glm::dot(p, along) * along + across * (std::sin(angle) / curvature_per_m) +
                        Vec3(0, 0, (1.0 - std::cos(angle)) / curvature_per_m));
  }
  return positions;
}

/// The bending energy of the sheet rolled to a cylinder, in J: B kappa^2 area / 2.
double rolling_energy_j(const Garment& garment, double rigidity_n_m) {
  double area_m2 = 0.0;
  for (const double m : garment.masses_kg) {
    area_m2 += m / garment.material.areal_density_kg_per_m2;
  }
  return 0.5 * rigidity_n_m * rolled_curvature_per_m * rolled_curvature_per_m * area_m2;
}

/// The bending energy of a sheet rolled to a cylinder, over B kappa^2 area / 2.
double cylinder_energy_ratio(const Mesh& flat, double axis_angle_rad) {
  const Garment garment = make_garment(flat);
  const std::vector<Vec3> positions = rolled(flat, axis_angle_rad);
  double energy = 0.0;
  for (const FlexuralElement& e : flexural_elements(garment)) {
    Vec3 deflection(0.0);
    for (std::size_t k = 0; k < 4; ++k) {
      deflection += e.weights[k] * positions[e.vertices[k]];
    }
    energy += 0.5 * e.stiffness_per_rigidity * glm::dot(deflection, deflection);
  }
  return energy / rolling_energy_j(garment, 1.0);
}

TEST(Flexural, ASheetResistsRollingWithItsRigidityForEveryMesh) {
  double sum = 0.0;
  for (const Index count : {9, 17, 33}) {
    EXPECT_NEAR(cylinder_energy_ratio(sheet(count, 1.0), 0.0), 1.0, 0.02) << count;
    for (const double angle : {0.0, 0.4, 0.8, 1.2, 1.6, 2.0, 2.4, 2.8}) {
      const double ratio = cylinder_energy_ratio(irregular_sheet(count, 1.0), angle);
      EXPECT_GT(ratio, 0.4) << count << ' ' << angle;
      EXPECT_LT(ratio, 1.9) << count << ' ' << angle;
      sum += ratio / 24.0;
    }
  }
  EXPECT_NEAR(sum, 1.0, 0.15);
}

/// The same ratio from accelerations: -1/2 x . M a, because bending is linear.
double cylinder_energy_ratio(const Garment& garment, Bending& bending, double rigidity_n_m,
                             double axis_angle_rad) {
  const Layout layout = make_layout(garment, make_pins(garment, {}));
  const std::vector<Vec3> positions = rolled(garment.mesh, axis_angle_rad);
  Float4Array rows(layout.row_count());
  Float4Array accelerations(layout.row_count());
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    rows[row] = float4_of(positions[layout.vertex_of_row[row]]);
  }
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  bending.add_accelerations(rows, kernels, accelerations);
  double energy = 0.0;
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    const Vec3 force = garment.masses_kg[layout.vertex_of_row[row]] * vector_of(accelerations[row]);
    energy -= 0.5 * glm::dot(vector_of(rows[row]), force);
  }
  return energy / rolling_energy_j(garment, rigidity_n_m);
}

TEST(Bending, WavesTooFastToFollowAreSlowedAndWideFoldsKeepTheirRigidity) {
  constexpr double rigidity_n_m = 1e-4;
  for (const Mesh& mesh : {sheet(49, 1.0), irregular_sheet(49, 1.0)}) {
    const Garment garment = make_garment(mesh);
    const Pins pins = make_pins(garment, {});
    const Layout layout = make_layout(garment, pins);
    Bending whole(garment, pins, layout, rigidity_n_m, 1e9);
    ASSERT_EQ(whole.level_count(), 1u);
    const double allowed_per_s = whole.largest_rate_per_s() / 12.0;
    Bending shared(garment, pins, layout, rigidity_n_m, allowed_per_s);
    EXPECT_GE(shared.level_count(), 3u);
    EXPECT_LE(shared.largest_rate_per_s(), 2.5 * allowed_per_s);
    double sum = 0.0;
    for (const double angle : {0.2, 0.7, 1.3, 1.9, 2.5}) {
      const double ratio = cylinder_energy_ratio(garment, shared, rigidity_n_m, angle);
      EXPECT_GT(ratio, 0.4) << angle;
      EXPECT_LT(ratio, 1.9) << angle;
      sum += ratio / 5.0;
    }
    EXPECT_NEAR(sum, 1.0, 0.25);
  }
}

/// How far, in m, the free end of a strip hangs down when a third of its length is pinned level.
double droop_m(Mesh mesh, double rigidity_n_m) {
  constexpr double pinned_m = 0.04;
  const double top_m = mesh.positions.front().y;
  const double bottom_m = mesh.positions.back().y;
  std::vector<Index> pinned;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (top_m - mesh.positions[v].y < pinned_m + 1e-6) {
      pinned.push_back(v);
    }
  }
  const double level_m = mesh.positions.front().z;
  Surroundings lying;
  lying.forces.gravity_m_per_s2 = {0.0, 0.0, -9.81};
  lying.forces.air_drag_per_s = 2.0;
  const SimulationSettings settings = bounded_by(0.01);
  const Material material = {.bending_rigidity_n_m = rigidity_n_m};
  const std::vector<Vec3> flat = mesh.positions;
  Simulation simulation(share(make_garment(std::move(mesh), {}, material)), pinned, settings, lying);
  for (int frame = 0; frame < 360; ++frame) {
    simulation.advance_frame();
  }
  double sum_m = 0.0;
  int count = 0;
  for (Index v = 0; v < flat.size(); ++v) {
    if (flat[v].y - bottom_m < 0.003) {
      sum_m += level_m - simulation.state().current[v].z;
      ++count;
    }
  }
  return sum_m / count;
}

TEST(Bending, TheSameFabricHangsAlikeForEveryMesh) {
  for (const double rigidity_n_m : {2e-5, 5e-5}) {
    std::vector<double> droops_m;
    for (const Index count : {7, 13, 25, 49}) {
      droops_m.push_back(droop_m(sheet(count, 0.12), rigidity_n_m));
    }
    const auto [least, most] = std::minmax_element(droops_m.begin(), droops_m.end());
    EXPECT_LT(*most, 1.13 * *least) << rigidity_n_m;
    EXPECT_LT(*most, 0.079) << "stiff enough not to hang straight down";
  }
  EXPECT_LT(droop_m(sheet(13, 0.12), 2e-4), 0.8 * droop_m(sheet(13, 0.12), 5e-5));
}

TEST(Bounded, KeepsTheBoundInEveryFrame) {
  const Garment garment = make_garment(irregular_sheet(25, 1.0));
  for (const Surroundings& surroundings : {Surroundings{}, shaken(), storm()}) {
    for (const double bound : {0.05, 0.01, 0.001}) {
      Simulation simulation(share(garment), {0, 24}, bounded_by(bound), surroundings);
      for (int frame = 0; frame < 180; ++frame) {
        simulation.advance_frame();
        const FrameReport& report = simulation.frame_report();
        EXPECT_TRUE(report.bound_promised && report.bound_kept);
        const double stretch = largest_stretch(garment, simulation.state().current);
        ASSERT_LE(stretch, bound);
        EXPECT_GE(report.raw_max_stretch, stretch - 2e-6);
      }
    }
  }
}

TEST(Bounded, ReportsABrokenBoundIfPinsPullTheClothApart) {
  Mesh mesh = sheet(9, 1.0);
  Garment garment = make_garment(mesh);
  // Rest lengths of a smaller cloth: its corners are pinned further apart than the bound allows.
  for (double& rest_m : garment.springs.rest_lengths_m) {
    rest_m *= 0.9;
  }
  SimulationSettings settings = bounded_by(0.01);
  settings.solver.max_substeps = 40;
  Simulation simulation(share(garment), {0, 8}, settings, {});
  simulation.advance_frame();
  EXPECT_FALSE(simulation.frame_report().bound_kept);
  EXPECT_GT(largest_stretch(garment, simulation.state().current), 0.05);
  EXPECT_EQ(simulation.frame_report().substeps, 40);
}

TEST(Bounded, ChoosesMoreStepsForATighterBoundAndFixesThemWhereAsked) {
  const Garment garment = make_garment(sheet(33, 1.0));
  std::vector<int> substeps;
  for (const double bound : {0.05, 0.01, 0.001}) {
    Simulation simulation(share(garment), {0, 32}, bounded_by(bound), {});
    for (int frame = 0; frame < 120; ++frame) {
      simulation.advance_frame();
    }
    substeps.push_back(simulation.frame_report().substeps);
  }
  EXPECT_LE(substeps[0], substeps[1]);
  EXPECT_LT(1.3 * substeps[1], substeps[2]);
  SimulationSettings fixed = bounded_by(0.01);
  fixed.solver.substeps = 77;
  Simulation simulation(share(garment), {0, 32}, fixed, {});
  simulation.advance_frame();
  EXPECT_EQ(simulation.frame_report().substeps, 77);
}

// Of such an edge single precision tells nothing once the cloth has moved by a centimetre.
TEST(Bounded, KeepsTheBoundOfEdgesOfTenNanometres) {
  Mesh mesh = sheet(17, 1.0);
  for (Index row = 2; row < 17; row += 3) {
    for (Index column = 2; column < 15; column += 4) {
      const Index v = row * 17 + column;
      mesh.positions[v] = mesh.positions[v + 1] - Vec3(1e-8, 0, 0);
    }
  }
  const Garment garment = make_garment(mesh);
  for (const double bound : {0.05, 0.01, 0.001}) {
    Simulation simulation(share(garment), {0, 16}, bounded_by(bound), {});
    for (int frame = 0; frame < 40; ++frame) {
      simulation.advance_frame();
      ASSERT_TRUE(simulation.frame_report().bound_kept) << bound << ", frame " << frame;
      ASSERT_LE(largest_stretch(garment, simulation.state().current), bound);
      ASSERT_LT(simulation.frame_report().substeps, 1000);
    }
  }
}

// A hundredfold stiffness makes no difference where steps follow neither; within what they follow it does.
TEST(Bounded, ReportsTheCompressionStiffnessItsStepsFollow) {
  const Garment garment = make_garment(irregular_sheet(17, 1.0));
  const auto compression_with = [&](double stiffness_n_per_m, int substeps) {
    SimulationSettings settings = bounded_by(0.01);
    settings.solver.substeps = substeps;
    const Material material = {.compression_stiffness_n_per_m = stiffness_n_per_m};
    Simulation simulation(share(with_material(garment, material)), {0, 16}, settings, {});
    for (int frame = 0; frame < 60; ++frame) {
      simulation.advance_frame();
    }
    return std::pair(measure_stretch(garment.springs, simulation.state().current).max_compression,
                     simulation.frame_report().followed_compression_n_per_m);
  };
  const auto [most, followed] = compression_with(0.0, 20);
  const auto [at_limit, same] = compression_with(followed, 20);
  EXPECT_EQ(followed, same);
  EXPECT_LT(at_limit, 0.8 * most);
  EXPECT_NEAR(compression_with(100.0 * followed, 20).first, at_limit, 0.2 * at_limit);
  EXPECT_NEAR(compression_with(30.0, 80).second, 16.0 * followed, 1e-6 * followed);
}

TEST(Bounded, NeverGainsEnergy) {
  GridSettings lying;
  lying.columns = lying.rows = 25;
  lying.plane = GridPlane::horizontal;
  const Garment garment = make_garment(make_grid(lying));
  Surroundings still;
  still.forces.air_drag_per_s = 0.0;
  for (const int substeps : {10, 40, 160}) {
    SimulationSettings settings = bounded_by(0.05);
    settings.solver.substeps = substeps;
    Simulation simulation(share(with_material(garment, {.bending_rigidity_n_m = 1e-4})), {0, 24}, settings,
                          still);
    for (int frame = 0; frame < 240; ++frame) {
      simulation.advance_frame();
      const Energy energy = measure_energy(garment, simulation.change(), {0, -9.81, 0});
      ASSERT_LE(energy.kinetic_j + energy.potential_j, 1e-6) << substeps << " substeps, frame " << frame;
    }
  }
}

/// Seconds between the first and the last of several passes of the lower edge through the middle, over their
/// number.
double swing_period_s(int substeps) {
  const Garment garment = make_garment(sheet(9, 1.0));
  SimulationSettings settings = bounded_by(0.05);
  settings.frame_rate_hz = 240.0;
  settings.solver.substeps = substeps;
  Surroundings surroundings;
  surroundings.forces.air_drag_per_s = 0.0;
  surroundings.forces.gravity_m_per_s2 = {0.0, -9.81 * std::cos(0.3), 9.81 * std::sin(0.3)};
  Simulation simulation(share(garment), {0, 1, 2, 3, 4, 5, 6, 7, 8}, settings, surroundings);
  for (int frame = 0; frame < 240; ++frame) {
    simulation.advance_frame();
  }
  surroundings.forces.gravity_m_per_s2 = {0.0, -9.81, 0.0};
  simulation.set_surroundings(surroundings);
  std::vector<double> passes_s;
  double before = 0.0;
  for (int frame = 0; frame < 1500; ++frame) {
    simulation.advance_frame();
    double z = 0.0;
    for (Index v = 72; v < 81; ++v) {
      z += simulation.state().current[v].z / 9.0;
    }
    if (before < 0.0 && z >= 0.0) {
      passes_s.push_back((frame - z / (z - before)) / 240.0);
    }
    before = z;
  }
  return (passes_s.back() - passes_s.front()) / static_cast<double>(passes_s.size() - 1);
}

TEST(Bounded, SwingsAtTheSamePeriodForAnySubsteps) {
  const double reference_s = swing_period_s(64);
  // A hanging chain of length 1 m swings at 2 pi sqrt(L / g) / (2.4048 / 2).
  EXPECT_NEAR(reference_s, 1.668, 0.06) << "less for a swing of 0.3 rad and a chain of eight links";
  for (const int substeps : {4, 16}) {
    EXPECT_NEAR(swing_period_s(substeps), reference_s, 0.02 * reference_s) << substeps;
  }
}

TEST(Bounded, FallsFreelyWithoutPins) {
  const Garment garment = make_garment(irregular_sheet(9, 1.0));
  Surroundings airless;
  airless.forces.air_drag_per_s = 0.0;
  airless.forces.wind.pressure_coefficient = airless.forces.wind.friction_coefficient = 0.0;
  Simulation simulation(share(garment), {}, bounded_by(0.01), airless);
  for (int frame = 0; frame < 60; ++frame) {
    simulation.advance_frame();
  }
  for (std::size_t v = 0; v < garment.mesh.positions.size(); ++v) {
    const double fallen_m = garment.mesh.positions[v].y - simulation.state().current[v].y;
    EXPECT_NEAR(fallen_m, 0.5 * 9.81, 0.1) << "first-order in a substep";
  }
  EXPECT_LT(largest_stretch(garment, simulation.state().current), 1e-4);
}

TEST(Bounded, StillAirBrakesAsTheFaintestWindDoes) {
  GridSettings lying;
  lying.plane = GridPlane::horizontal;
  const Garment garment = make_garment(make_grid(lying));
  std::vector<double> fallen_m;
  for (const double speed_m_per_s : {0.0, 1e-6}) {
    Surroundings surroundings;
    surroundings.forces.wind.speed_m_per_s = speed_m_per_s;
    Simulation simulation(share(garment), {}, bounded_by(0.01), surroundings);
    for (int frame = 0; frame < 60; ++frame) {
      simulation.advance_frame();
    }
    fallen_m.push_back(garment.mesh.positions[40].y - simulation.state().current[40].y);
  }
  EXPECT_NEAR(fallen_m[0], fallen_m[1], 1e-4);
  EXPECT_LT(fallen_m[0], 0.5 * 4.9) << "a sheet that lies on the air falls slowly";
}

TEST(Bounded, AllVectorUnitsEndInTheSameState) {
  const Garment garment = make_garment(irregular_sheet(17, 1.0));
  std::vector<std::uint64_t> hashes;
  for (const VectorUnit unit : available_vector_units()) {
    SimulationSettings settings;
    settings.solver.method = BoundedSettings{.max_stretch = 0.01, .vector_unit = unit};
    Simulation simulation(share(garment), {0, 16}, settings, storm());
    for (int frame = 0; frame < 60; ++frame) {
      simulation.advance_frame();
    }
    hashes.push_back(hash(simulation.state()));
  }
  for (const std::uint64_t h : hashes) {
    EXPECT_EQ(h, hashes.front());
  }
}

TEST(Bounded, TheNumberOfThreadsChangesNothing) {
  const Garment garment = make_garment(irregular_sheet(97, 1.0));
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4}) {
    SimulationSettings settings;
    settings.solver.method = BoundedSettings{.max_stretch = 0.02, .threads = threads};
    Simulation simulation(share(garment), {0, 96}, settings, storm());
    for (int frame = 0; frame < 4; ++frame) {
      simulation.advance_frame();
    }
    hashes.push_back(hash(simulation.state()));
  }
  for (std::size_t k = 1; k < hashes.size(); ++k) {
    EXPECT_EQ(hashes[k], hashes.front());
  }
}

TEST(Bounded, ComesToRestAndFallsAsleep) {
  const Garment garment = make_garment(irregular_sheet(25, 1.0));
  Simulation simulation(share(garment), {0, 24}, bounded_by(0.01), {});
  double slow_since_s = 0.0;
  for (int frame = 0; frame < 900; ++frame) {
    simulation.advance_frame();
    if (rms_speed(simulation.change()) > 1e-3) {
      slow_since_s = simulation.state().time_s;
    }
  }
  EXPECT_LT(slow_since_s, 8.0);
  EXPECT_TRUE(simulation.state().asleep);
}

}  // namespace
}  // namespace taut::sim
