// The solver that promises a bound on stretch.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sheets.hpp"
#include "sim/measures.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"
#include "sim/solvers/bounded/within_bound.hpp"

namespace taut::sim {
namespace {

SimulationSettings bounded_by(double max_stretch, BoundKind bound) {
  SimulationSettings settings;
  settings.solver.method = BoundedSettings{.bound = bound, .max_stretch = max_stretch};
  return settings;
}

double largest_stretch(const Garment& garment, std::span<const Vec3> positions) {
  double largest = 0.0;
  for (std::size_t s = 0; s < garment.springs.begin_index(SpringKind::flexural); ++s) {
    const auto [i, j] = garment.springs.ends[s];
    largest =
        std::max(largest, glm::length(positions[i] - positions[j]) / garment.springs.rest_lengths_m[s] - 1.0);
  }
  return largest;
}

/// Returns the largest stretch that the bound holds.
double max_held_stretch(const Garment& garment, std::span<const Vec3> positions, BoundKind bound) {
  const double springs = largest_stretch(garment, positions);
  return bound == BoundKind::springs ? springs
                                     : std::max(springs, measure_surface_stretch(garment, positions).max);
}

Surroundings storm() {
  Surroundings surroundings;
  surroundings.forces.wind.speed_m_per_s = 12.0;
  surroundings.forces.wind.gust_amplitude = 0.5;
  surroundings.forces.wind.gust_turn = 0.3;
  return surroundings;
}

Surroundings shake() {
  Surroundings surroundings;
  surroundings.pin_motion = {{0.1, 0.0, 0.0}, 1.0};
  return surroundings;
}

/// Tests that both kinds of bounds have to pass.
class Bounded : public testing::TestWithParam<BoundKind> {};

INSTANTIATE_TEST_SUITE_P(Holding, Bounded, testing::ValuesIn(all_bound_kinds),
                         [](const auto& kind) { return to_name(kind.param); });

TEST_P(Bounded, KeepsTheBoundInEveryFrame) {
  const Garment garment = make_garment(irregular_sheet(25, 1.0));
  for (const Surroundings& surroundings : {Surroundings{}, shake(), storm()}) {
    for (const double bound : {0.05, 0.01, 0.001}) {
      SimulationSettings settings;
      // The solver promises less: sheets keep the bound in stronger winds than shirts do.
      settings.solver.method =
          BoundedSettings{.bound = GetParam(), .max_stretch = bound, .allow_exceeding = true};
      Simulation simulation(share(garment), {0, 24}, settings, surroundings);
      for (int frame = 0; frame < 180; ++frame) {
        simulation.advance_frame();
        const FrameReport& report = simulation.frame_report();
        EXPECT_TRUE(report.bound_promised && report.bound_kept);
        const double stretch = max_held_stretch(garment, simulation.state().current, GetParam());
        ASSERT_LE(stretch, bound);
        EXPECT_GE(report.raw_max_stretch, stretch - 2e-6);
      }
    }
  }
}

TEST_P(Bounded, ReportsABrokenBoundIfPinsPullTheClothApart) {
  // The pinned corners of a smaller cloth are further apart than the bound allows.
  const Garment garment = make_garment(sheet(9, 0.9));
  SimulationSettings settings = bounded_by(0.01, GetParam());
  settings.solver.max_substeps = 40;
  // The cloth is pulled so far that it folds over itself in its own plane, where contact would end the run.
  std::get<BoundedSettings>(settings.solver.method).allow_crossing = true;
  Simulation simulation(share(garment), {0, 8}, settings, {}, sheet(9, 1.0).positions);
  simulation.advance_frame();
  EXPECT_FALSE(simulation.frame_report().bound_kept);
  EXPECT_GT(max_held_stretch(garment, simulation.state().current, GetParam()), 0.05);
  EXPECT_LT(max_held_stretch(garment, simulation.state().current, GetParam()), 2.0) << "nothing is thrown away";
  EXPECT_EQ(simulation.frame_report().substeps, 40);
}

TEST_P(Bounded, ChoosesMoreStepsForATighterBoundAndFixesThemWhereAsked) {
  const Garment garment = make_garment(sheet(33, 1.0));
  std::vector<int> substeps;
  for (const double bound : {0.05, 0.01, 0.001}) {
    Simulation simulation(share(garment), {0, 32}, bounded_by(bound, GetParam()), {});
    for (int frame = 0; frame < 120; ++frame) {
      simulation.advance_frame();
    }
    substeps.push_back(simulation.frame_report().substeps);
  }
  EXPECT_LE(substeps[0], substeps[1]);
  EXPECT_LT(1.3 * substeps[1], substeps[2]);
  SimulationSettings fixed = bounded_by(0.01, GetParam());
  fixed.solver.substeps = 77;
  Simulation simulation(share(garment), {0, 32}, fixed, {});
  simulation.advance_frame();
  EXPECT_EQ(simulation.frame_report().substeps, 77);
}

// Single precision cannot measure such an edge once the cloth has moved by a centimetre.
TEST_P(Bounded, KeepsTheBoundOfEdgesOfTenNanometres) {
  Mesh mesh = sheet(17, 1.0);
  for (Index row = 2; row < 17; row += 3) {
    for (Index column = 2; column < 15; column += 4) {
      const Index v = row * 17 + column;
      mesh.positions[v] = mesh.positions[v + 1] - Vec3(1e-8, 0, 0);
    }
  }
  const Garment garment = make_garment(mesh);
  for (const double bound : {0.05, 0.01, 0.001}) {
    Simulation simulation(share(garment), {0, 16}, bounded_by(bound, GetParam()), {});
    for (int frame = 0; frame < 40; ++frame) {
      simulation.advance_frame();
      ASSERT_TRUE(simulation.frame_report().bound_kept) << bound << ", frame " << frame;
      ASSERT_LE(max_held_stretch(garment, simulation.state().current, GetParam()), bound);
      ASSERT_LT(simulation.frame_report().substeps, 1200);
    }
  }
}

TEST(WithinBound, NoVertexIsMovedToWhereContactDoesNotLetIt) {
  const Mesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0.3, 0.01, 0}}, {{0, 1, 2}}, {}};
  const Garment garment = make_garment(mesh);
  const BoundedSettings settings = {.bound = BoundKind::surface, .max_stretch = 0.01};
  std::vector<Vec3> positions = mesh.positions;
  positions[2].y *= 1.01001;
  const std::vector<Vec3> before = positions;
  int asked = 0;
  const auto nowhere = [&](Index vertex, const Vec3& position_m) {
    EXPECT_NE(position_m, before[vertex]) << "only vertices that were moved are asked for";
    ++asked;
    return false;
  };
  EXPECT_FALSE(keeps_bound_in_double(garment, make_pins(garment, {0}), settings, positions, nowhere));
  EXPECT_EQ(positions, before);
  EXPECT_GT(asked, 0);
}

TEST(WithinBound, TrianglesTooLongByLessThanAMicrometreAreShortenedInDoublePrecision) {
  const Mesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0.3, 0.01, 0}}, {{0, 1, 2}}, {}};
  const Garment garment = make_garment(mesh);
  const BoundedSettings settings = {.bound = BoundKind::surface, .max_stretch = 0.01};
  const auto higher = [&](double times) {
    std::vector<Vec3> positions = mesh.positions;
    positions[2].y *= times;
    return positions;
  };
  std::vector<Vec3> slightly = higher(1.01001);
  ASSERT_LT(largest_stretch(garment, slightly), 0.01) << "no spring is too long";
  EXPECT_TRUE(keeps_bound_in_double(garment, make_pins(garment, {0}), settings, slightly));
  EXPECT_LE(measure_surface_stretch(garment, slightly).max, 0.01);
  EXPECT_EQ(slightly[0], mesh.positions[0]);

  std::vector<Vec3> far = higher(1.5);
  EXPECT_FALSE(keeps_bound_in_double(garment, make_pins(garment, {}), settings, far));
  EXPECT_EQ(far, higher(1.5)) << "what is too much for it stays";
  std::vector<Vec3> pinned = higher(1.01001);
  EXPECT_FALSE(keeps_bound_in_double(garment, make_pins(garment, {0, 1, 2}), settings, pinned));
  BoundedSettings springs = settings;
  springs.bound = BoundKind::springs;
  EXPECT_TRUE(keeps_bound_in_double(garment, make_pins(garment, {}), springs, far));
}

// A stiffness above the largest one that the steps follow makes no difference; stiffness below it does.
TEST_P(Bounded, ReportsTheCompressionStiffnessItsStepsFollow) {
  const Garment garment = make_garment(irregular_sheet(17, 1.0));
  const auto compression_with = [&](double stiffness_n_per_m, int substeps) {
    SimulationSettings settings = bounded_by(0.01, GetParam());
    std::get<BoundedSettings>(settings.solver.method).contact =
        false;  // contact keeps folds from being pressed flat
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

TEST_P(Bounded, NeverGainsEnergy) {
  GridSettings lying;
  lying.columns = lying.rows = 25;
  lying.plane = GridPlane::horizontal;
  const Garment garment = make_garment(make_grid(lying));
  Surroundings still;
  still.forces.air_drag_per_s = 0.0;
  for (const int substeps : {10, 40, 160}) {
    SimulationSettings settings = bounded_by(0.05, GetParam());
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

/// Returns the time in s between the first and the last of several passes of the lower edge through the middle, divided
/// by their number.
double swing_period_s(int substeps, BoundKind bound) {
  const Garment garment = make_garment(sheet(9, 1.0));
  SimulationSettings settings = bounded_by(0.05, bound);
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

TEST_P(Bounded, SwingsAtTheSamePeriodForAnySubsteps) {
  const double reference_s = swing_period_s(64, GetParam());
  // A hanging chain of length 1 m swings at 2 pi sqrt(L / g) / (2.4048 / 2).
  EXPECT_NEAR(reference_s, 1.668, 0.06) << "less for a swing of 0.3 rad and a chain of eight links";
  for (const int substeps : {4, 16}) {
    EXPECT_NEAR(swing_period_s(substeps, GetParam()), reference_s, 0.02 * reference_s) << substeps;
  }
}

TEST_P(Bounded, FallsFreelyWithoutPins) {
  const Garment garment = make_garment(irregular_sheet(9, 1.0));
  Surroundings airless;
  airless.forces.air_drag_per_s = 0.0;
  airless.forces.wind.pressure_coefficient = airless.forces.wind.friction_coefficient = 0.0;
  Simulation simulation(share(garment), {}, bounded_by(0.01, GetParam()), airless);
  for (int frame = 0; frame < 60; ++frame) {
    simulation.advance_frame();
  }
  for (std::size_t v = 0; v < garment.mesh.positions.size(); ++v) {
    const double fallen_m = garment.mesh.positions[v].y - simulation.state().current[v].y;
    EXPECT_NEAR(fallen_m, 0.5 * 9.81, 0.1) << "first-order in a substep";
  }
  EXPECT_LT(max_held_stretch(garment, simulation.state().current, GetParam()), 1e-4);
}

TEST_P(Bounded, StillAirBrakesAsTheFaintestWindDoes) {
  GridSettings lying;
  lying.plane = GridPlane::horizontal;
  const Garment garment = make_garment(make_grid(lying));
  std::vector<double> fallen_m;
  for (const double speed_m_per_s : {0.0, 1e-6}) {
    Surroundings surroundings;
    surroundings.forces.wind.speed_m_per_s = speed_m_per_s;
    Simulation simulation(share(garment), {}, bounded_by(0.01, GetParam()), surroundings);
    for (int frame = 0; frame < 60; ++frame) {
      simulation.advance_frame();
    }
    fallen_m.push_back(garment.mesh.positions[40].y - simulation.state().current[40].y);
  }
  EXPECT_NEAR(fallen_m[0], fallen_m[1], 1e-4);
  EXPECT_LT(fallen_m[0], 0.5 * 4.9) << "a sheet that lies on the air falls slowly";
}

TEST_P(Bounded, AllVectorUnitsEndInTheSameState) {
  const Garment garment = make_garment(irregular_sheet(17, 1.0));
  std::vector<std::uint64_t> hashes;
  for (const VectorUnit unit : available_vector_units()) {
    SimulationSettings settings;
    settings.solver.method = BoundedSettings{.bound = GetParam(), .max_stretch = 0.01, .vector_unit = unit};
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

TEST_P(Bounded, TheNumberOfThreadsChangesNothing) {
  const Garment garment = make_garment(irregular_sheet(97, 1.0));
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4}) {
    SimulationSettings settings;
    settings.solver.method = BoundedSettings{.bound = GetParam(), .max_stretch = 0.02, .threads = threads};
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

// Triangles fold over each other where the bound holds their edges alone. Contact would keep the folds apart, and some
// sheets would take longer to rest.
TEST_P(Bounded, ComesToRestAndFallsAsleep) {
  const Garment garment = make_garment(irregular_sheet(25, 1.0));
  SimulationSettings settings = bounded_by(0.01, GetParam());
  std::get<BoundedSettings>(settings.solver.method).contact = GetParam() == BoundKind::surface;
  Simulation simulation(share(garment), {0, 24}, settings, {});
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
