#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sim/forces.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::sim {
namespace {

Vec3 total_wind_force(const Garment& garment, const State& state, const Wind& wind,
                      double time_step_s = 1e-9) {
  std::vector<Vec3> forces(state.current.size(), Vec3(0.0));
  add_wind_forces(garment, state, wind, {}, time_step_s, forces);
  Vec3 total(0.0);
  for (const Vec3& f : forces) {
    total += f;
  }
  return total;
}

TEST(Wind, PressesHeadOnByHalfRhoAreaSpeedSquared) {
  GridSettings grid;
  grid.width_m = 2.0;
  grid.height_m = 1.5;
  const Garment garment = make_garment(make_grid(grid));
  const State state = make_state(garment);
  for (const double speed : {1.0, 10.0}) {
    Wind wind;
    wind.speed_m_per_s = speed;
    wind.direction = {0, 0, -2};
    const Vec3 force = total_wind_force(garment, state, wind);
    EXPECT_NEAR(force.z, -0.5 * 1.2 * 3.0 * speed * speed * wind.pressure_coefficient, 1e-4);
    EXPECT_NEAR(force.x, 0.0, 1e-12);
    EXPECT_NEAR(force.y, 0.0, 1e-12);
  }
}

double square(double x) { return x * x; }

/// Air that meets the grid, whose normal is z, at this angle of incidence.
Wind slanting_wind(double speed_m_per_s, double angle) {
  Wind wind;
  wind.speed_m_per_s = speed_m_per_s;
  wind.direction = {std::cos(angle), 0.0, -std::sin(angle)};
  wind.friction_coefficient = 0.0;
  return wind;
}

// The coefficients of Rayleigh (1876), 2 pi sin a / (4 + pi sin a), at angles of his table.
TEST(Wind, PressesAsOnAFlatPlateAtAnyAngle) {
  const Garment garment = make_garment(make_grid({}));
  const State state = make_state(garment);
  constexpr double degree = 3.141592653589793 / 180.0;
  const double at_right_angle = 2.0 * 3.141592653589793 / (4.0 + 3.141592653589793);
  for (const auto& [degrees, coefficient] : {std::pair(90.0, 0.8798), {30.0, 0.5640}, {20.0, 0.4235}, {10.0, 0.2400}}) {
    const Vec3 force = total_wind_force(garment, state, slanting_wind(7.0, degrees * degree));
    EXPECT_NEAR(-force.z, 0.5 * 1.2 * square(7.0) * Wind{}.pressure_coefficient * coefficient / at_right_angle,
                2e-3 * 0.6 * square(7.0)) << degrees;
    EXPECT_NEAR(force.x, 0.0, 1e-9) << "along the normal alone";
  }
}

TEST(Wind, ItsForceInALongStepIsThatOfTheLawsDerivative) {
  const Garment garment = make_garment(make_grid({}));
  const State still = make_state(garment);
  for (const double angle : {0.02, 0.3, 0.8, 1.4}) {
    const Wind wind = slanting_wind(6.0, angle);
    const auto pressure_at = [&](double retreat_m_per_s) {
      State state = still;
      state.time_step_s = 0.01;
      for (Vec3& p : state.previous) p.z += 0.01 * retreat_m_per_s;
      return -total_wind_force(garment, state, wind, 1e-12).z;
    };
    const double slope = (pressure_at(-1e-4) - pressure_at(1e-4)) / 2e-4;
    const double time_step_s = 0.05;
    const double density_kg_per_m2 = garment.material.areal_density_kg_per_m2;
    const double expected = pressure_at(0.0) / (1.0 + time_step_s * slope / density_kg_per_m2);
    EXPECT_NEAR(-total_wind_force(garment, still, wind, time_step_s).z, expected, 1e-5 * expected) << angle;
  }
}

TEST(Wind, OnlyRubsAClothItBlowsAlong) {
  const Garment garment = make_garment(make_grid({}));
  Wind wind;
  wind.speed_m_per_s = 4.0;
  wind.direction = {1, 0, 0};
  const Vec3 force = total_wind_force(garment, make_state(garment), wind);
  EXPECT_NEAR(force.x, 0.5 * 1.2 * 1.0 * 16.0 * wind.friction_coefficient, 1e-6);
  EXPECT_NEAR(force.z, 0.0, 1e-12);
}

TEST(Wind, DoesNotPushAClothThatMovesWithTheAir) {
  const Garment garment = make_garment(make_grid({}));
  State state = make_state(garment);
  state.time_step_s = 0.01;
  for (Vec3& p : state.previous) {
    p -= Vec3(0, 0, -3.0) * 0.01;
  }
  Wind wind;
  wind.speed_m_per_s = 3.0;
  EXPECT_NEAR(glm::length(total_wind_force(garment, state, wind)), 0.0, 1e-9);
}

TEST(Wind, StillAirBrakesAsTheFaintestWindDoes) {
  const Garment garment = make_garment(make_grid({}));
  State state = make_state(garment);
  state.time_step_s = 0.01;
  for (Vec3& p : state.previous) {
    p -= Vec3(0, 0, -3.0) * 0.01;
  }
  const Vec3 still = total_wind_force(garment, state, {});
  EXPECT_NEAR(still.z, 0.5 * 1.2 * 9.0 * Wind{}.pressure_coefficient, 1e-4);
  Wind faintest;
  faintest.speed_m_per_s = 1e-9;
  EXPECT_NEAR(glm::length(total_wind_force(garment, state, faintest) - still), 0.0, 1e-6);
}

TEST(Wind, CannotMakeClothFasterThanAirInOneStep) {
  const Garment garment = make_garment(make_grid({}));
  Wind wind;
  wind.speed_m_per_s = 1000.0;
  const double time_step_s = 1.0;
  const Vec3 force = total_wind_force(garment, make_state(garment), wind, time_step_s);
  const double mass_kg = 0.15;
  EXPECT_LT(glm::length(force) / mass_kg * time_step_s, 1000.0);
}

TEST(Gusts, StayWithinTheirAmplitudeAndRepeatForTheSameSeed) {
  Wind wind;
  wind.speed_m_per_s = 10.0;
  wind.gust_amplitude = 0.3;
  Wind other = wind;
  other.gust_seed = 2;
  double lowest = 100.0, highest = 0.0, max_change = 0.0, difference = 0.0, before = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const double speed = glm::length(wind_velocity(wind, k * 0.01));
    EXPECT_EQ(speed, glm::length(wind_velocity(wind, k * 0.01)));
    lowest = std::min(lowest, speed);
    highest = std::max(highest, speed);
    max_change = k > 0 ? std::max(max_change, std::abs(speed - before)) : 0.0;
    difference = std::max(difference, std::abs(speed - glm::length(wind_velocity(other, k * 0.01))));
    before = speed;
  }
  EXPECT_GE(lowest, 7.0);
  EXPECT_LE(highest, 13.0);
  EXPECT_LT(lowest, 8.5);
  EXPECT_GT(highest, 11.5);
  EXPECT_LT(max_change, 0.3) << "smooth";
  EXPECT_GT(difference, 1.0) << "another seed, other gusts";
}

TEST(Gusts, TurnTheWindSidewaysWithoutChangingItsMainDirection) {
  Wind wind;
  wind.speed_m_per_s = 5.0;
  wind.direction = {0, 0, -1};
  wind.gust_turn = 0.2;
  double widest = 0.0;
  for (int k = 0; k < 1000; ++k) {
    const Vec3 air = wind_velocity(wind, k * 0.01);
    EXPECT_NEAR(air.z, -5.0, 1e-12);
    widest = std::max(widest, std::abs(air.x));
  }
  EXPECT_GT(widest, 0.5);
  EXPECT_LE(widest, 1.0);
}

TEST(ExternalForces, AddUp) {
  const Garment garment = make_garment(make_grid({}));
  std::vector<Vec3> forces(81, Vec3(0.0));
  ExternalForces external;
  external.gravity_m_per_s2 = {0, -10, 0};
  external.artificial_forces = {{5, {1, 2, 3}}, {5, {1, 0, 0}}};
  add_external_forces(garment, make_state(garment), external, {}, 0.01, forces);
  const double weight = garment.masses_kg[5] * 10;
  EXPECT_NEAR(forces[5].x, 2.0, 1e-15);
  EXPECT_NEAR(forces[5].y, 2.0 - weight, 1e-15);
  EXPECT_NEAR(forces[40].y, -garment.masses_kg[40] * 10, 1e-15);
}

// A force cancels the whole drag, so that the sheet would move against the wind if drag were smaller.
TEST(Wind, PressesWhatIsHeldAsMuchAsWhatFalls) {
  const Garment garment = make_garment(make_grid({}));
  Surroundings surroundings;
  surroundings.forces.gravity_m_per_s2 = {0.0, 0.0, 0.0};
  surroundings.forces.air_drag_per_s = 0.0;
  surroundings.forces.wind.speed_m_per_s = 10.0;
  std::vector<Vec3> pressed(garment.mesh.positions.size(), Vec3(0.0));
  add_wind_forces(garment, make_state(garment), surroundings.forces.wind, {}, 1e-12, pressed);
  for (Index v = 0; v < pressed.size(); ++v) {
    surroundings.forces.artificial_forces.push_back({v, -pressed[v]});
  }
  Simulation simulation(share(garment), {}, {}, surroundings);
  for (int frame = 0; frame < 12; ++frame) {
    simulation.advance_frame();
    double fastest_m_per_s = 0.0;
    for (Index v = 0; v < pressed.size(); ++v) {
      fastest_m_per_s = std::max(fastest_m_per_s, glm::length(velocity(simulation.state(), v)));
    }
    EXPECT_LT(fastest_m_per_s, 0.1 * surroundings.forces.wind.speed_m_per_s) << frame;
  }
}

}  // namespace
}  // namespace taut::sim
