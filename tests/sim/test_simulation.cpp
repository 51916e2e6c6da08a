#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "sim/measures.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"
#include "sim/solvers/bounded/promise.hpp"

namespace taut::sim {
namespace {

Garment pinned_cloth() {
  return make_garment(make_grid({}));
}

const std::vector<Index> corners = {0, 8};

void run(Simulation& simulation, int frames) {
  for (int frame = 0; frame < frames; ++frame) {
    simulation.advance_frame();
  }
}

TEST(State, BeginsAtRestAndRotatesWithoutCopies) {
  State state = make_state(pinned_cloth());
  EXPECT_EQ(state.previous, state.current);
  EXPECT_EQ(state.predicted, state.current);
  const Vec3* previous = state.previous.data();
  const Vec3* current = state.current.data();
  const Vec3* predicted = state.predicted.data();
  rotate_positions(state);
  EXPECT_EQ(state.previous.data(), current);
  EXPECT_EQ(state.current.data(), predicted);
  EXPECT_EQ(state.predicted.data(), previous);
}

TEST(State, KeepsVelocitiesWhenTheTimeStepChanges) {
  State state = make_state(pinned_cloth());
  set_time_step(state, 0.01);
  state.previous[3] -= Vec3(0.02, 0, 0.01);
  const Vec3 before = velocity(state, 3);
  set_time_step(state, 0.0025);
  EXPECT_NEAR(glm::length(velocity(state, 3) - before), 0.0, 1e-12);
}

TEST(State, HashTellsTheLastBitApart) {
  State state = make_state(pinned_cloth());
  const auto before = hash(state);
  EXPECT_EQ(before, hash(make_state(pinned_cloth())));
  state.current[80].z = std::nextafter(state.current[80].z, 1.0);
  EXPECT_NE(before, hash(state));
}

TEST(Simulation, RepeatsBitForBit) {
  Simulation first(share(pinned_cloth()), corners, {}, {});
  Simulation second(share(pinned_cloth()), corners, {}, {});
  run(first, 30);
  run(second, 30);
  EXPECT_EQ(hash(first.state()), hash(second.state()));
}

TEST(Simulation, PinsStayAndClothHangsBelowThem) {
  Simulation simulation(share(pinned_cloth()), corners, {}, {});
  run(simulation, 60);
  EXPECT_EQ(simulation.state().current[0], simulation.garment().mesh.positions[0]);
  EXPECT_EQ(simulation.state().current[8], simulation.garment().mesh.positions[8]);
}

TEST(Simulation, MoreIterationsStretchLess) {
  double before = 1.0;
  for (const int iterations : {1, 4, 16}) {
    SimulationSettings settings;
    settings.solver.method = StrongSettings{.iterations = iterations};
    settings.solver.substeps = 2;
    Simulation simulation(share(pinned_cloth()), corners, settings, {});
    run(simulation, 240);
    const double stretch = measure_stretch(simulation.garment().springs, simulation.state().current).max;
    EXPECT_LT(stretch, 0.6 * before);
    before = stretch;
  }
}

TEST(Simulation, NeverGainsEnergy) {
  GridSettings lying;
  lying.plane = GridPlane::horizontal;
  Simulation simulation(share(make_garment(make_grid(lying))), corners, {}, {});
  for (int frame = 0; frame < 300; ++frame) {
    simulation.advance_frame();
    const Energy energy = measure_energy(simulation.garment(), simulation.change(), {0, -9.81, 0});
    EXPECT_LE(energy.kinetic_j + energy.potential_j, 1e-9) << "frame " << frame;
  }
}

TEST(Simulation, AGarmentAtRestFallsAsleepUntilSomethingChanges) {
  Simulation simulation(share(pinned_cloth()), corners, {}, {});
  run(simulation, 1200);
  ASSERT_TRUE(simulation.state().asleep);
  EXPECT_EQ(simulation.state().previous, simulation.state().current)
      << "it wakes without the last bit of its motion";
  const auto at_rest = hash(simulation.state());
  const auto steps = simulation.state().step_count;
  run(simulation, 10);
  EXPECT_EQ(hash(simulation.state()), at_rest);
  EXPECT_EQ(simulation.state().step_count, steps) << "no work is done";

  Surroundings same = simulation.surroundings();
  simulation.set_surroundings(same);
  EXPECT_TRUE(simulation.state().asleep);

  Surroundings windy = same;
  windy.forces.wind.speed_m_per_s = 3.0;
  simulation.set_surroundings(windy);
  EXPECT_FALSE(simulation.state().asleep);
  run(simulation, 5);
  EXPECT_NE(hash(simulation.state()), at_rest);
}

TEST(Simulation, NewPinsAndSettingsWakeIt) {
  Simulation simulation(share(pinned_cloth()), corners, {}, {});
  run(simulation, 1200);
  ASSERT_TRUE(simulation.state().asleep);
  simulation.set_pins({0});
  EXPECT_FALSE(simulation.state().asleep);
  run(simulation, 2400);
  ASSERT_TRUE(simulation.state().asleep);
  SimulationSettings settings = simulation.settings();
  settings.solver.max_substeps += 1;
  simulation.set_settings(settings);
  EXPECT_FALSE(simulation.state().asleep);
}

TEST(Simulation, SpeedsAreThoseBetweenTheShapesOfFrames) {
  Simulation simulation(share(pinned_cloth()), corners, {}, {});
  EXPECT_EQ(rms_speed(simulation.change()), 0.0) << "before the first frame";
  for (int frame = 0; frame < 5; ++frame) {
    const std::vector<Vec3> before = simulation.state().current;
    simulation.advance_frame();
    double squares = 0.0;
    for (std::size_t v = 0; v < before.size(); ++v) {
      const Vec3 moved = simulation.state().current[v] - before[v];
      squares += glm::dot(moved, moved);
    }
    EXPECT_NEAR(rms_speed(simulation.change()), 60.0 * std::sqrt(squares / 81.0), 1e-12);
  }
}

// A pendulum passes the same place again and again; at its turning points it is slow.
TEST(Simulation, ClothThatSwingsIsNotAtRest) {
  Surroundings vacuum;
  vacuum.forces.air_drag_per_s = 0.0;
  vacuum.forces.wind.pressure_coefficient = vacuum.forces.wind.friction_coefficient = 0.0;
  GridSettings lying;
  lying.plane = GridPlane::horizontal;
  Simulation simulation(share(make_garment(make_grid(lying))), corners, {}, vacuum);
  run(simulation, 600);
  EXPECT_FALSE(simulation.state().asleep);
}

TEST(Simulation, APinThatIsNoVertexLeavesTheGarmentAsItWas) {
  Simulation simulation(share(pinned_cloth()), corners, {}, {});
  run(simulation, 3);
  Simulation untouched(share(pinned_cloth()), corners, {}, {});
  run(untouched, 3);
  EXPECT_THROW(simulation.set_pins({0, 81}), std::invalid_argument);
  EXPECT_EQ(simulation.pins().vertices, corners);
  EXPECT_EQ(simulation.garment().mesh.positions.size(), 81U);
  run(simulation, 3);
  run(untouched, 3);
  EXPECT_EQ(hash(simulation.state()), hash(untouched.state()));
}

TEST(Simulation, ANewBoundMovesTheClothWithinItBeforeTheNextFrame) {
  Simulation simulation(share(pinned_cloth()), corners, {}, {});
  run(simulation, 60);
  const std::vector<Vec3> before = simulation.state().current;
  const Vec3 velocity_before = velocity(simulation.state(), 40);
  ASSERT_GT(measure_surface_stretch(simulation.garment(), before).max, 0.0006);
  SimulationSettings settings = simulation.settings();
  settings.solver.method = BoundedSettings{.max_stretch = 0.0005};
  simulation.set_settings(settings);
  EXPECT_LE(measure_surface_stretch(simulation.garment(), simulation.state().current).max, 0.0005);
  EXPECT_EQ(simulation.state().current[8], before[8]);
  EXPECT_NEAR(glm::length(velocity(simulation.state(), 40) - velocity_before), 0.0, 1e-9) << "not thrown";
}

TEST(Simulation, WithoutAnyForceNothingMoves) {
  Surroundings nothing;
  nothing.forces.gravity_m_per_s2 = {0, 0, 0};
  for (const SolverMethod& method : {SolverMethod(StrongSettings{}), SolverMethod(BoundedSettings{})}) {
    SimulationSettings settings;
    settings.solver.method = method;
    Simulation simulation(share(pinned_cloth()), corners, settings, nothing);
    run(simulation, 100);
    EXPECT_TRUE(simulation.state().asleep);
    // Bending forces in single precision cancel up to their last digits, and gradients are not quite 1.
    const double rounding_m = solver_kind(method) == SolverKind::bounded ? 2e-7 : 0.0;
    for (std::size_t v = 0; v < simulation.state().current.size(); ++v) {
      EXPECT_LE(glm::length(simulation.state().current[v] - simulation.garment().mesh.positions[v]),
                rounding_m);
    }
  }
}

// Free cloth falls as a stone does, by s = 1/2 g t^2, and goes on as fast while its weight is taken away.
TEST(Simulation, GravityChangesAlongItsPath) {
  for (const SolverMethod& method : {SolverMethod(StrongSettings{}), SolverMethod(BoundedSettings{})}) {
    SimulationSettings settings;
    settings.solver.method = method;
    Surroundings surroundings;
    surroundings.forces.air_drag_per_s = 0.0;
    surroundings.forces.wind.pressure_coefficient = surroundings.forces.wind.friction_coefficient = 0.0;
    surroundings.forces.gravity_path = {{0.5, {0, 0, 0}}, {0.5001, {0, 9.81, 0}}};
    Simulation simulation(share(pinned_cloth()), {}, settings, surroundings);
    const Vec3 before = simulation.state().current[40];
    run(simulation, 60);
    EXPECT_NEAR(before.y - simulation.state().current[40].y, 9.81 * (0.125 + 0.25), 0.06);
    EXPECT_NEAR(velocity(simulation.state(), 40).y, -0.5 * 9.81, 0.1);
    EXPECT_TRUE(is_steady(surroundings, 0.6));
    EXPECT_FALSE(is_steady(surroundings, 0.3));
  }
  ExternalForces external;
  external.gravity_path = {{1.0, {0, 0, 0}}, {2.0, {0, 29.43, 0}}};
  EXPECT_DOUBLE_EQ(gravity_at(external, 1.5).y, 0.5 * 9.81);
  EXPECT_DOUBLE_EQ(max_gravity_m_per_s2(external), 2.0 * 9.81);
}

TEST(Simulation, GustsAndMovingPinsKeepItAwake) {
  Surroundings gusty;
  gusty.forces.wind.speed_m_per_s = 1e-6;
  gusty.forces.wind.gust_amplitude = 0.5;
  Surroundings shaken;
  shaken.pin_motion.amplitude_m = {1e-9, 0, 0};
  for (const Surroundings& s : {gusty, shaken}) {
    Simulation simulation(share(pinned_cloth()), corners, {}, s);
    run(simulation, 1200);
    EXPECT_FALSE(simulation.state().asleep);
  }
}

TEST(Simulation, MovesPinsHarmonically) {
  Surroundings shaken;
  shaken.pin_motion = {{0.1, 0, 0.05}, 1.0};
  Simulation simulation(share(pinned_cloth()), corners, {}, shaken);
  run(simulation, 15);  // a quarter of a period
  const Vec3 moved = simulation.state().current[0] - simulation.garment().mesh.positions[0];
  EXPECT_NEAR(moved.x, 0.1, 1e-12);
  EXPECT_NEAR(moved.z, 0.05, 1e-12);
}

TEST(Simulation, StopsWithAMessageWhenItDiverges) {
  SimulationSettings settings;
  settings.solver.method = IdealSettings{{.structural_n_per_m = 1e9}};
  settings.solver.substeps = 1;
  Simulation simulation(share(pinned_cloth()), corners, settings, {});
  try {
    run(simulation, 600);
    FAIL() << "it should have diverged";
  } catch (const Diverged& error) {
    EXPECT_NE(std::string(error.what()).find("not finite"), std::string::npos);
  }
}

TEST(Simulation, RefusesImpossibleSettings) {
  SimulationSettings settings;
  settings.solver.substeps = -1;
  EXPECT_THROW(Simulation(share(pinned_cloth()), corners, settings, {}), std::invalid_argument);
  settings = {};
  settings.frame_rate_hz = 0.0;
  EXPECT_THROW(Simulation(share(pinned_cloth()), corners, settings, {}), std::invalid_argument);
}

TEST(Simulation, RefusesImpossibleSurroundingsAndKeepsTheOnesItHas) {
  const auto refusal_of = [](const Surroundings& impossible) -> std::string {
    EXPECT_THROW(Simulation(share(pinned_cloth()), corners, {}, impossible), std::invalid_argument);
    Simulation simulation(share(pinned_cloth()), corners, {}, {});
    try {
      simulation.set_surroundings(impossible);
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(simulation.surroundings(), Surroundings{});
      return error.what();
    }
    return "";
  };
  Surroundings surroundings;
  surroundings.forces.air_drag_per_s = -0.1;
  EXPECT_EQ(refusal_of(surroundings), "the air drag must be at least 0 per second");
  surroundings = {};
  surroundings.forces.artificial_forces = {{80, {1, 2, 3}}, {81, {1, 2, 3}}};
  EXPECT_EQ(refusal_of(surroundings), "a force acts on vertex 81, but there are only 81");
  surroundings = {};
  surroundings.forces.grabbed_vertices = {{99, {}, 10.0, 1.0}};
  EXPECT_EQ(refusal_of(surroundings), "a hand holds vertex 99, but there are only 81");
}

TEST(Simulation, RefusesWhatItsSolverDoesNotPromise) {
  const auto refusal = [](const BoundedSettings& bounded, const Surroundings& surroundings) -> std::string {
    SimulationSettings settings;
    settings.solver.method = bounded;
    try {
      Simulation(share(pinned_cloth()), corners, settings, surroundings);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal({.max_stretch = 5e-5}, {}),
            "max_stretch: found 5e-05, expected at least 0.0001: cloth that may not give at all cannot be "
            "kept in every pose; allow_exceeding = true tries all the same");
  EXPECT_EQ(refusal({.max_stretch = 5e-5, .allow_exceeding = true}, {}), "");
  constexpr BoundKind springs = BoundKind::springs;
  constexpr BoundKind surface = BoundKind::surface;
  Surroundings windy;
  windy.forces.wind.speed_m_per_s = 60.0;
  EXPECT_EQ(
      refusal({.bound = springs, .max_stretch = 5e-4}, windy),
      "max_stretch = 0.0005 of the springs is not promised in gusts of 60 m/s; expected at most 50 m/s, "
      "or a bound of at least 0.00055; allow_exceeding = true tries all the same");
  EXPECT_EQ(refusal({.bound = springs, .max_stretch = 6e-4}, windy), "");
  EXPECT_EQ(refusal({.bound = surface, .max_stretch = 2e-3}, windy),
            "max_stretch = 0.002 of the surface is not promised in gusts of 60 m/s; expected at most 30 m/s, "
            "or a bound of at least 0.004; allow_exceeding = true tries all the same");
  EXPECT_EQ(refusal({.bound = surface, .max_stretch = 4.01e-3}, windy), "");
  EXPECT_NE(refusal({.bound = surface, .max_stretch = 2e-4}, {}).find("a bound of at least 0.00032;"),
            std::string::npos)
      << "its own weight is too much";
  Surroundings pulled;
  pulled.forces.artificial_forces = {{40, {0.0, -2e8, 0.0}}};
  EXPECT_NE(refusal({.bound = springs, .max_stretch = 1e-2}, pulled).find("expected at most 1e+08 N; allow"),
            std::string::npos);

  SimulationSettings tight;
  tight.solver.method = BoundedSettings{.max_stretch = 5e-4};
  Simulation simulation(share(pinned_cloth()), corners, tight, {});
  EXPECT_THROW(simulation.set_surroundings(windy), std::invalid_argument);
  EXPECT_EQ(simulation.surroundings(), Surroundings{}) << "nothing has changed";
  Simulation in_wind(share(pinned_cloth()), corners, {}, windy);
  EXPECT_THROW(in_wind.set_settings(tight), std::invalid_argument);
}

TEST(Simulation, RefusesClothThatItCannotKeepApart) {
  const auto refusal = [](double thickness_m, const BoundedSettings& bounded) -> std::string {
    SimulationSettings settings;
    settings.solver.method = bounded;
    try {
      Garment garment = pinned_cloth();
      garment.material.thickness_m = thickness_m;
      Simulation(share(std::move(garment)), {0}, settings, {});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const double edge_m = mean_edge_m(pinned_cloth().springs);
  EXPECT_EQ(refusal(1.0, {}).substr(0, 38), "thickness: found 1 m (1000 mm), edges ") << refusal(1.0, {});
  EXPECT_EQ(refusal(0.99 * max_thickness_per_edge * edge_m, {}), "");
  EXPECT_NE(refusal(1.01 * max_thickness_per_edge * edge_m, {}), "");
  EXPECT_EQ(refusal(1.0, {.contact = false}), "");
  EXPECT_EQ(refusal(0.9e-5, {}), "thickness: found 9e-06 m (0.009 mm), expected at least 0.01 mm");
  EXPECT_EQ(refusal(min_thickness_m, {}), "");
}

TEST(Simulation, RefusesAMaterialOrASolverThatDoNotGoTogetherAndStaysAsItWas) {
  Simulation simulation(share(pinned_cloth()), {0}, {}, {});
  Material thick = simulation.garment().material;
  thick.thickness_m = 1.0;
  SimulationSettings apart;
  apart.solver.method = BoundedSettings{.contact = true};
  SimulationSettings together;
  together.solver.method = BoundedSettings{.contact = false};
  simulation.set_settings(apart);
  EXPECT_THROW(simulation.set_material(thick), std::invalid_argument);
  EXPECT_NE(simulation.garment().material, thick);
  simulation.set_settings(together);
  simulation.set_material(thick);
  EXPECT_THROW(simulation.set_settings(apart), std::invalid_argument);
  EXPECT_EQ(simulation.settings(), together);
}

TEST(Simulation, BeginsInAShapeOtherThanTheRestShape) {
  Simulation before(share(pinned_cloth()), corners, {}, {});
  run(before, 1200);
  ASSERT_TRUE(before.state().asleep);
  const std::vector<Vec3> draped = before.state().current;
  Simulation after(share(pinned_cloth()), corners, {}, {}, draped);
  EXPECT_EQ(after.state().current, draped);
  EXPECT_EQ(rms_speed(after.change()), 0.0);
  EXPECT_EQ(after.garment().mesh.positions, pinned_cloth().mesh.positions);
  run(after, 120);
  EXPECT_TRUE(after.state().asleep);
  for (std::size_t v = 0; v < draped.size(); ++v) {
    EXPECT_LT(glm::distance(after.state().current[v], draped[v]), 1e-3) << v;
  }
}

TEST(Simulation, AStartBeyondTheBoundIsMovedWithinIt) {
  std::vector<Vec3> pulled = pinned_cloth().mesh.positions;
  for (Vec3& p : pulled) {
    p.y *= 1.2;
  }
  SimulationSettings settings;
  settings.solver.method = BoundedSettings{.max_stretch = 0.01};
  Simulation simulation(share(pinned_cloth()), corners, settings, {}, pulled);
  EXPECT_LE(measure_stretch(simulation.garment().springs, simulation.state().current).max, 0.01);
  EXPECT_EQ(simulation.state().current[8], pulled[8]);
  settings.solver.method = StrongSettings{};
  EXPECT_EQ(Simulation(share(pinned_cloth()), corners, settings, {}, pulled).state().current, pulled);
}

TEST(Simulation, RefusesAStartOfAnotherGarmentOrThatIsNotFinite) {
  const auto begin_in = [](std::vector<Vec3> start_m) {
    Simulation(share(pinned_cloth()), corners, {}, {}, std::move(start_m));
  };
  EXPECT_THROW(begin_in(std::vector<Vec3>(80)), std::invalid_argument);
  std::vector<Vec3> damaged = pinned_cloth().mesh.positions;
  begin_in(damaged);
  damaged[7].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(begin_in(damaged), std::invalid_argument);
}

TEST(Simulation, AnotherMaterialWakesTheClothAndIsItsOwn) {
  const auto garment = share(pinned_cloth());
  Simulation simulation(garment, corners, {}, {});
  run(simulation, 1200);
  ASSERT_TRUE(simulation.state().asleep);
  simulation.set_material(garment->material);
  EXPECT_TRUE(simulation.state().asleep);
  simulation.set_material({.areal_density_kg_per_m2 = 0.3});
  EXPECT_FALSE(simulation.state().asleep);
  EXPECT_EQ(garment->material, Material{}) << "what others share stays";
  EXPECT_NEAR(simulation.garment().masses_kg[40], 2.0 * garment->masses_kg[40], 1e-15);
  EXPECT_NEAR(simulation.pins().inverse_masses_per_kg[40], 0.5 / garment->masses_kg[40], 1e-9);
}

TEST(Measures, StretchIsThatOfThePulledSprings) {
  const Garment garment = make_garment(make_grid({}));
  std::vector<Vec3> pulled = garment.mesh.positions;
  for (Vec3& p : pulled) {
    p.x *= 1.1;
    p.y *= 0.9;
  }
  const Stretch stretch = measure_stretch(garment.springs, pulled);
  EXPECT_NEAR(stretch.max, 0.1, 1e-12);
  EXPECT_NEAR(stretch.p99, 0.1, 1e-12);
  EXPECT_NEAR(stretch.mean, 0.0, 1e-12);
  EXPECT_NEAR(stretch.max_compression, 0.1, 1e-12);
  const std::vector<double> at_vertices = vertex_stretch(garment.springs, pulled);
  EXPECT_NEAR(at_vertices[40], 0.1, 1e-12);
}

TEST(Measures, The99thPercentileLeavesOutTheWorstHundredth) {
  const Garment garment = make_garment(make_grid({.columns = 17, .rows = 17}));
  std::vector<Vec3> torn = garment.mesh.positions;
  torn[0].x -= 1.0;
  const Stretch stretch = measure_stretch(garment.springs, torn);
  EXPECT_GT(stretch.max, 7.0);
  EXPECT_LT(stretch.p99, 1.0);
  EXPECT_GT(stretch.p99, -1e-12);
}

TEST(Measures, NoMoreThanOneSpringInAHundredExceedsThe99thPercentile) {
  const Garment garment = make_garment(make_grid({}));
  const std::size_t springs = garment.springs.structural_count;
  ASSERT_EQ(springs, 144U) << "a hundredth of them is more than one and less than two";
  // No two rows and no two columns are equally far apart.
  std::vector<Vec3> pulled = garment.mesh.positions;
  for (Vec3& p : pulled) {
    p += Vec3(0.010 * p.x * p.x, 0.013 * p.y * p.y, 0.0);
    p.x *= 1.0 + 0.0001 * p.y;
    p.y *= 1.0 + 0.0002 * p.x;
  }
  const double p99 = measure_stretch(garment.springs, pulled).p99;
  std::size_t above = 0;
  for (std::size_t s = 0; s < springs; ++s) {
    const auto [i, j] = garment.springs.ends[s];
    const double stretch = glm::distance(pulled[i], pulled[j]) / garment.springs.rest_lengths_m[s] - 1.0;
    above += stretch > p99 ? 1 : 0;
  }
  EXPECT_EQ(above, 1U);
}

TEST(Measures, ConvergenceIsTheLengthOfTheLastMove) {
  const std::vector<Vec3> before(81, Vec3(1.0));
  std::vector<Vec3> now = before;
  now[4] += Vec3(0.03, 0.04, 0);
  const ShapeChange change = {before, now, 0.5};
  EXPECT_NEAR(vertex_convergence_m(change, 4), 0.05, 1e-15);
  EXPECT_NEAR(measure_convergence(change).max_m, 0.05, 1e-15);
  EXPECT_NEAR(measure_convergence(change).rms_m, 0.05 / 9.0, 1e-15);
  EXPECT_NEAR(rms_speed(change), 0.1 / 9.0, 1e-15);
}

TEST(Measures, TheFirstLostVertexIsFound) {
  std::vector<Vec3> positions(5, Vec3(1.0));
  EXPECT_EQ(first_lost(positions), 5u);
  positions[3].y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(first_lost(positions), 3u);
  positions[2].z = -0.9 * max_coordinate_m;
  EXPECT_EQ(first_lost(positions), 3u);
  positions[2].z = -1.1 * max_coordinate_m;
  EXPECT_EQ(first_lost(positions), 2u) << "single precision, in which it is drawn, ends sooner than double";
  positions[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(first_lost(positions), 1u);
}

}  // namespace
}  // namespace taut::sim
