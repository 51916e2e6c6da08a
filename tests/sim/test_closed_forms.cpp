// The method compared with results from pencil and paper.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sim/measures.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"
#include "sim/step.hpp"
#include "vacuum.hpp"

namespace taut::sim {
namespace {

constexpr double gravity = 9.81;

/// A chain of mass points at `positions`, each joined to the next, without a surface.
Garment chain(const std::vector<Vec3>& positions, double mass_kg) {
  Garment garment;
  garment.mesh.positions = positions;
  garment.masses_kg.assign(positions.size(), mass_kg);
  garment.material.areal_density_kg_per_m2 = 1.0;
  for (Index v = 0; v + 1 < positions.size(); ++v) {
    garment.springs.ends.push_back({v, v + 1});
    garment.springs.rest_lengths_m.push_back(glm::length(positions[v + 1] - positions[v]));
  }
  garment.springs.structural_count = garment.springs.ends.size();
  return garment;
}

SimulationSettings steps(const SolverMethod& method, int substeps) {
  SimulationSettings settings;
  settings.frame_rate_hz = 50.0;
  settings.solver.method = method;
  settings.solver.substeps = substeps;
  return settings;
}

TEST(Verlet, PredictsByEquation1) {
  const std::vector<Vec3> previous = {{1, 2, 3}, {5, 5, 5}};
  const std::vector<Vec3> current = {{2, 4, 8}, {6, 6, 6}};
  const std::vector<Vec3> forces = {{4, 0, 0}, {9, 9, 9}};
  std::vector<Vec3> predicted(2);
  predict_positions(previous, current, forces, std::vector{0.5, 0.0}, 0.25, predicted);
  // 2 p(t) - p(t - dt) + a dt^2 with a = (2, 0, 0)
  EXPECT_EQ(predicted[0], Vec3(3 + 2 * 0.0625, 6, 13));
  EXPECT_EQ(predicted[1], current[1]) << "a pinned vertex stays";
}

TEST(FreeFall, IsExactForConstantAcceleration) {
  const Garment cloth = make_garment(make_grid({}));
  Simulation simulation(share(cloth), {}, steps(StrongSettings{.iterations = 2}, 10), vacuum(gravity));
  for (int frame = 0; frame < 50; ++frame) {
    simulation.advance_frame();
  }
  const double dt = 1.0 / 500.0;
  const int n = 500;
  // The start at rest has p(-dt) = p(0), so that p(n dt) = p(0) + a dt^2 n (n + 1) / 2, the parabola through those two.
  const double fallen_m = gravity * dt * dt * n * (n + 1) / 2.0;
  for (std::size_t v = 0; v < cloth.mesh.positions.size(); ++v) {
    const Vec3 moved = simulation.state().current[v] - cloth.mesh.positions[v];
    EXPECT_NEAR(moved.y, -fallen_m, 1e-11);
    EXPECT_NEAR(moved.x, 0.0, 1e-13);
  }
}

TEST(TwoParticleSpring, SwingsAtTheFrequencyOfItsReducedMass) {
  const double mass_kg = 0.02;
  const double stiffness_n_per_m = 8.0;
  Garment pair = chain({{0, 0, 0}, {1, 0, 0}}, mass_kg);
  pair.mesh.positions[1].x = 1.1;  // starts 10 % too long
  SimulationSettings settings =
      steps(IdealSettings{{.structural_n_per_m = stiffness_n_per_m, .damping_n_s_per_m = 0.0}}, 40);
  settings.rest_settings.speed_m_per_s = 0.0;
  Simulation simulation(share(pair), {}, settings, vacuum(0.0));

  const double omega = std::sqrt(stiffness_n_per_m / (mass_kg / 2.0));
  for (int frame = 1; frame <= 100; ++frame) {
    simulation.advance_frame();
    const State& state = simulation.state();
    const double length = glm::length(state.current[1] - state.current[0]);
    // Verlet started from p(-dt) = p(0) lags by half a step.
    EXPECT_NEAR(length, 1.0 + 0.1 * std::cos(omega * (state.time_s + state.time_step_s / 2)), 2e-4);
    EXPECT_NEAR(state.current[0].x + state.current[1].x, 1.1, 1e-11) << "the centre of mass stays";
  }
}

TEST(TwoParticleSpring, LosesItsSwingToTheSpringsDamping) {
  const double mass_kg = 0.02;
  const double damping = 0.01;
  Garment pair = chain({{0, 0, 0}, {1, 0, 0}}, mass_kg);
  pair.mesh.positions[1].x = 1.1;
  const SimulationSettings settings =
      steps(IdealSettings{{.structural_n_per_m = 8.0, .damping_n_s_per_m = damping}}, 40);
  Simulation simulation(share(pair), {}, settings, vacuum(0.0));
  double max_swing_in_second_two = 0.0;
  for (int frame = 1; frame <= 100; ++frame) {
    simulation.advance_frame();
    const State& state = simulation.state();
    if (state.time_s > 1.0) {
      max_swing_in_second_two =
          std::max(max_swing_in_second_two, std::abs(glm::length(state.current[1] - state.current[0]) - 1.0));
    }
  }
  // Amplitude falls as exp(-c t / 2 m) with the reduced mass. The first maximum past 1 s comes within half a
  // period of 2 pi / 28.3 s; sampled once a frame, up to 4 % of its peak is missed.
  const double rate = damping / (2.0 * mass_kg / 2.0);
  EXPECT_LT(max_swing_in_second_two, 0.1 * std::exp(-rate * 1.0));
  EXPECT_GT(max_swing_in_second_two, 0.096 * std::exp(-rate * 1.12));
}

/// Returns the time in s from one passage through the vertical in +x direction to the next.
double measured_period(const Garment& pendulum, const SimulationSettings& settings) {
  Simulation simulation(share(pendulum), {0}, settings, vacuum(gravity));
  double first = 0.0;
  for (int frame = 0; frame < 100000; ++frame) {
    simulation.advance_frame();
    const State& state = simulation.state();
    const double before = state.previous[1].x;
    const double now = state.current[1].x;
    if (before < 0.0 && now >= 0.0) {
      const double passage = state.time_s - state.time_step_s * now / (now - before);
      if (first > 0.0) {
        return passage - first;
      }
      first = passage;
    }
  }
  return 0.0;
}

TEST(Pendulum, HasThePeriodOfItsLength) {
  const double length_m = 0.7;
  const double amplitude_rad = 0.2;
  const Garment pendulum =
      chain({{0, 0, 0}, {-length_m * std::sin(amplitude_rad), -length_m * std::cos(amplitude_rad), 0}}, 0.1);
  SimulationSettings settings = steps(StrongSettings{.iterations = 1}, 1);
  settings.frame_rate_hz = 1000.0;
  // Complete elliptic integral of the pendulum, as a series in the amplitude.
  const double a2 = amplitude_rad * amplitude_rad;
  const double period_s =
      2.0 * std::numbers::pi * std::sqrt(length_m / gravity) * (1.0 + a2 / 16.0 + 11.0 * a2 * a2 / 3072.0);
  EXPECT_NEAR(measured_period(pendulum, settings), period_s, 2e-4 * period_s);
}

TEST(HangingChain, TakesTheShapeOfACatenary) {
  const int links = 40;
  const double length_m = 1.2;
  const double span_m = 1.0;
  // Starts as a V, each link at its rest length.
  std::vector<Vec3> start;
  const double half_drop = std::sqrt(length_m * length_m - span_m * span_m) / 2.0;
  for (int v = 0; v <= links; ++v) {
    const double s = 2.0 * v / links - 1.0;
    start.push_back({s * span_m / 2.0, -half_drop * (1.0 - std::abs(s)), 0.0});
  }
  const SimulationSettings settings = steps(StrongSettings{.iterations = 40}, 20);
  Surroundings air = vacuum(gravity);
  air.forces.air_drag_per_s = 4.0;
  Simulation simulation(share(chain(start, 0.01)), {0, static_cast<Index>(links)}, settings, air);
  for (int frame = 0; frame < 600 && !simulation.state().asleep; ++frame) {
    simulation.advance_frame();
  }
  EXPECT_TRUE(simulation.state().asleep);

  // length = 2 a sinh(span / 2a); Newton's iteration for a.
  double a = 0.5;
  for (int k = 0; k < 50; ++k) {
    const double u = span_m / (2.0 * a);
    a -= (2.0 * a * std::sinh(u) - length_m) / (2.0 * std::sinh(u) - 2.0 * u * std::cosh(u));
  }
  const double sag_m = a * (std::cosh(span_m / (2.0 * a)) - 1.0);
  for (const Vec3& p : simulation.state().current) {
    EXPECT_NEAR(p.y, a * std::cosh(p.x / a) - a - sag_m, 0.005 * sag_m);
  }
  EXPECT_LT(measure_stretch(simulation.garment().springs, simulation.state().current).max, 0.002);
}

TEST(VerticalChainOfIdealSprings, StretchesByTheWeightBelow) {
  const double mass_kg = 0.01;
  const double stiffness = 40.0;
  Simulation simulation(
      share(chain({{0, 0, 0}, {0, -0.1, 0}, {0, -0.2, 0}, {0, -0.3, 0}}, mass_kg)), {0},
      [&] {
        SimulationSettings settings = steps(IdealSettings{{.structural_n_per_m = stiffness}}, 20);
        settings.rest_settings.speed_m_per_s = 1e-9;
        return settings;
      }(),
      [] {
        Surroundings air = vacuum(gravity);
        air.forces.air_drag_per_s = 5.0;
        return air;
      }());
  for (int frame = 0; frame < 1000; ++frame) {
    simulation.advance_frame();
  }
  for (Index s = 0; s < 3; ++s) {
    const double length = simulation.state().current[s].y - simulation.state().current[s + 1].y;
    EXPECT_NEAR(length, 0.1 + (3 - s) * mass_kg * gravity / stiffness, 1e-6);
  }
}

}  // namespace
}  // namespace taut::sim
