#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "sheets.hpp"
#include "sim/measures.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"
#include "sim/solvers/implicit/system.hpp"
#include "vacuum.hpp"

namespace taut::sim::implicit {
namespace {

/// Two triangles that are stretched, sheared and folded, all at random.
struct Crumpled {
  Garment garment = make_garment(irregular_sheet(2, 0.1));
  std::vector<Vec3> positions = garment.mesh.positions;
  std::vector<Vec3> velocities;

  Crumpled() {
    std::mt19937 random(3);
    const auto offset = [&] { return 2.0 * static_cast<double>(random()) / 4294967296.0 - 1.0; };
    for (Vec3& p : positions) {
      p = 1.5 * p + 0.03 * Vec3(offset(), offset(), offset());
      velocities.push_back(0.1 * Vec3(offset(), offset(), offset()));
    }
  }
};

using Positions = std::vector<Vec3>;
using ConditionOf = std::function<Condition(const Positions&)>;

std::vector<ConditionOf> conditions(const Garment& garment) {
  const WovenTriangle t = woven_triangles(garment)[1];
  const Hinge hinge = hinges(garment).at(0);
  return {[=](const Positions& p) { return stretch_condition(t, t.along_warp, p); },
          [=](const Positions& p) { return stretch_condition(t, t.along_weft, p); },
          [=](const Positions& p) {
            return spring_condition({1, 2}, 0.1, p);
          },
          [=](const Positions& p) { return shear_condition(t, p); },
          [=](const Positions& p) { return bend_condition(hinge, p); }};
}

constexpr double small = 1e-6;

/// Returns the derivative of f by a coordinate of `vectors`, as a difference quotient.
template <class F>
auto difference(std::vector<Vec3> vectors, Index vertex, int axis, double step, F f) {
  vectors[vertex][axis] += step;
  const auto above = f(vectors);
  vectors[vertex][axis] -= 2.0 * step;
  return (above - f(vectors)) / (2.0 * step);
}

TEST(ImplicitConditions, HaveTheGradientsOfTheirDifferences) {
  const Crumpled cloth;
  for (const ConditionOf& of : conditions(cloth.garment)) {
    const Condition c = of(cloth.positions);
    EXPECT_GT(std::abs(c.value), 1e-4);
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        const double expected = difference(cloth.positions, c.vertices[i], axis, small * 0.1,
                                           [&](const Positions& p) { return of(p).value; });
        EXPECT_NEAR(c.gradients[i][axis], expected, 1e-6 * (1.0 + std::abs(expected)));
      }
    }
  }
}

/// The system of one condition: forces, and their derivatives by positions and velocities.
struct Assembled {
  BlockMatrix matrix;
  std::vector<Vec3> right_side = std::vector<Vec3>(4, Vec3(0.0));

  Assembled(const Condition& c, const Stiffness& stiffness, double h, const std::vector<Vec3>& velocities)
      : matrix(4, std::vector<Edge>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}) {
    add_condition(c, stiffness, {h, velocities, matrix, right_side});
  }
};

// The matrix of a step of 1 s without damping is -df/dx; shear and bend leave out the second derivative.
TEST(ImplicitSystem, HasTheDerivativesOfTheForcesByPositions) {
  const Crumpled cloth;
  const std::vector<Vec3> still(4, Vec3(0.0));
  const std::vector<ConditionOf> all = conditions(cloth.garment);
  for (std::size_t k = 0; k < 3; ++k) {
    const Stiffness stiffness = {7.0, 0.0};
    const auto force = [&](const Positions& p) {
      return Assembled(all[k](p), stiffness, 1.0, still).right_side;
    };
    const auto energy = [&](const Positions& p) { return 0.5 * 7.0 * std::pow(all[k](p).value, 2); };
    Assembled now(all[k](cloth.positions), stiffness, 1.0, still);
    ASSERT_GT(all[k](cloth.positions).value, 0.0) << "in tension nothing is left out";
    for (Index i = 0; i < 4; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(force(cloth.positions)[i][axis], -difference(cloth.positions, i, axis, small, energy),
                    1e-6);
        for (Index j = 0; j < 4; ++j) {
          const Vec3 expected =
              difference(cloth.positions, i, axis, small, [&](const Positions& p) { return force(p)[j]; });
          EXPECT_NEAR(glm::length(now.matrix.at(j, i)[axis] + expected), 0.0, 1e-5) << k << i << j;
        }
      }
    }
  }
}

// The right side of a step of almost no time is h f, and its matrix is -h df/dv.
TEST(ImplicitSystem, HasTheDampingAndItsDerivativesByVelocities) {
  const Crumpled cloth;
  const double h = 1e-9;
  for (const ConditionOf& of : conditions(cloth.garment)) {
    const Stiffness stiffness = {2.0, 0.5};
    const Condition c = of(cloth.positions);
    const auto force = [&](const std::vector<Vec3>& v) {
      std::vector<Vec3> f = Assembled(c, stiffness, h, v).right_side;
      for (Vec3& one : f) {
        one /= h;
      }
      return f;
    };
    Assembled now(c, stiffness, h, cloth.velocities);
    double rate = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
      rate += glm::dot(c.gradients[i], cloth.velocities[c.vertices[i]]);
    }
    const std::vector<Vec3> forces = force(cloth.velocities);
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
      const Vec3 expected = -(2.0 * c.value + 0.5 * 2.0 * rate) * c.gradients[i];
      EXPECT_NEAR(glm::length(forces[c.vertices[i]] - expected), 0.0, 1e-6);
    }
    for (Index i = 0; i < 4; ++i) {
      for (Index j = 0; j < 4; ++j) {
        for (int axis = 0; axis < 3; ++axis) {
          const Vec3 by_velocity = difference(cloth.velocities, i, axis, 1e-3,
                                              [&](const std::vector<Vec3>& v) { return force(v)[j]; });
          EXPECT_NEAR(glm::length(now.matrix.at(j, i)[axis] / h + by_velocity), 0.0, 1e-4);
        }
      }
    }
  }
}

TEST(ImplicitSystem, StaysDefiniteInClothThatIsPressedTogether) {
  Crumpled cloth;
  for (Vec3& p : cloth.positions) {
    p *= 0.05;
  }
  for (const ConditionOf& of : conditions(cloth.garment)) {
    const Assembled pressed(of(cloth.positions), {100.0, 0.0}, 1.0, std::vector<Vec3>(4, Vec3(0.0)));
    std::vector<Vec3> image(4);
    pressed.matrix.multiply(cloth.velocities, image);
    double product = 0.0;
    for (std::size_t v = 0; v < 4; ++v) {
      product += glm::dot(cloth.velocities[v], image[v]);
    }
    EXPECT_GE(product, -1e-12);
  }
}

// A sheet around a cylinder has the energy of a plate, 1/2 B area / radius^2.
TEST(ImplicitConditions, BendASheetLikeAPlate) {
  const double radius_m = 0.5;
  const Garment garment =
      make_garment(make_grid({.columns = 41, .rows = 11, .width_m = 1.0, .height_m = 0.3}));
  Positions around = garment.mesh.positions;
  for (Vec3& p : around) {
    p = {radius_m * std::sin(p.x / radius_m), p.y, radius_m * std::cos(p.x / radius_m)};
  }
  double energy_j = 0.0;
  for (const Hinge& hinge : hinges(garment)) {
    energy_j += 0.5 * hinge.shape * std::pow(bend_condition(hinge, around).value, 2);
  }
  // One of 40 folds is missing, where the sheet ends.
  EXPECT_NEAR(energy_j, 0.5 * (1.0 * 39 / 40) * 0.3 / (radius_m * radius_m), 1e-3 * energy_j);
  for (const Hinge& hinge : hinges(make_garment({around, garment.mesh.triangles, {}}))) {
    EXPECT_NEAR(bend_condition(hinge, around).value, 0.0, 1e-12) << "at rest when made so";
  }
}

TEST(ConjugateGradients, SolveAKnownSystemAndKeepWhatIsGiven) {
  std::vector<Vec3> expected(4);
  std::mt19937 random(5);
  BlockMatrix matrix(4, std::vector<Edge>{{0, 1}, {1, 2}, {2, 3}, {0, 3}});
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
  for (Index i = 0; i < 4; ++i) {
    expected[i] = {number(), number(), number()};
    matrix.at(i, i) += Mat3(3.0);
    const Index j = (i + 1) % 4;
    const Vec3 g = {number(), number(), number()}, f = {number(), number(), number()};
    matrix.at(i, i) += glm::outerProduct(g, g);
    matrix.at(j, j) += glm::outerProduct(f, f);
    matrix.at(i, j) += glm::outerProduct(g, f);
    matrix.at(j, i) += glm::outerProduct(f, g);
  }
  std::vector<Vec3> b(4), x(4, Vec3(0.0));
  matrix.multiply(expected, b);
  x[2] = expected[2];
  b[2] = Vec3(1e3);
  const int iterations = solve(matrix, b, std::vector<double>{1.0, 1.0, 0.0, 1.0}, 1e-12, x);
  EXPECT_LE(iterations, 12);
  EXPECT_GE(iterations, 2);
  EXPECT_EQ(x[2], expected[2]);
  for (Index v = 0; v < 4; ++v) {
    EXPECT_NEAR(glm::distance(x[v], expected[v]), 0.0, 1e-10) << v;
  }
}

constexpr double exact = 1e-12;

SimulationSettings case_settings(const ImplicitSettings& implicit, std::optional<int> substeps = {}) {
  SimulationSettings settings;
  settings.solver.method = implicit;
  settings.solver.substeps = substeps;
  settings.rest_settings.speed_m_per_s = 0.0;
  return settings;
}

TEST(Implicit, FallsFreely) {
  const Garment cloth = make_garment(make_grid({}));
  Simulation simulation(share(cloth), {}, case_settings({.tolerance = exact}, 3), vacuum(9.81));
  for (int frame = 0; frame < 20; ++frame) {
    simulation.advance_frame();
  }
  const double h = 1.0 / 180.0;
  for (Index v = 0; v < cloth.mesh.positions.size(); ++v) {
    const Vec3 moved = simulation.state().current[v] - cloth.mesh.positions[v];
    EXPECT_NEAR(moved.y, -9.81 * h * h * 60 * 61 / 2.0, 1e-9);
  }
}

// Drag is implicit: stable however strong, v' = (v + h g) / (1 + h c).
TEST(Implicit, FallsThroughAirAtItsTerminalSpeed) {
  const Garment cloth = make_garment(make_grid({}));
  Surroundings thick = vacuum(9.81);
  thick.forces.air_drag_per_s = 1000.0;
  Simulation simulation(share(cloth), {}, case_settings({.tolerance = exact}), thick);
  double speed = 0.0;
  for (int frame = 0; frame < 20; ++frame) {
    simulation.advance_frame();
    speed = (speed + 9.81 / 60.0) / (1.0 + 1000.0 / 60.0);
    EXPECT_NEAR(velocity(simulation.state(), 40).y, -speed, 1e-9);
  }
}

/// Returns the extension after each step of a cell of four masses, two of them pinned, which starts stretched downwards
/// by `stretched_m`.
std::vector<double> swings(const ImplicitSettings& implicit, double stretched_m, int steps) {
  const Garment cell = make_garment(make_grid({.columns = 2, .rows = 2, .width_m = 0.3, .height_m = 0.2}));
  std::vector<Vec3> start = cell.mesh.positions;
  start[2].y -= stretched_m;
  start[3].y -= stretched_m;
  Simulation simulation(share(cell), {0, 1}, case_settings(implicit, 1), vacuum(0.0), start);
  std::vector<double> all;
  for (int step = 0; step < steps; ++step) {
    simulation.advance_frame();
    all.push_back(cell.mesh.positions[2].y - simulation.state().current[2].y);
    EXPECT_NEAR(simulation.state().current[2].x, cell.mesh.positions[2].x, 1e-12);
  }
  return all;
}

// x'' = -w^2 x - c x' by backward Euler: v' = (v - h w^2 x) / (1 + h c + h^2 w^2), x' = x + h v'. One step
// damps the swing by 1 / sqrt(1 + h^2 w^2) without any c.
TEST(Implicit, DampsASwingAsBackwardEulerDoes) {
  for (const double damping_s : {0.0, 0.01}) {
    const ImplicitSettings implicit = {
        .stretch_n_per_m = 0.5, .shear_n_per_m = 0.2, .damping_s = damping_s, .tolerance = exact};
    // Each lower mass is a quarter of the cell; each triangle pulls with k width / (2 height).
    const double w_squared = (0.5 * 0.3 / (2.0 * 0.2)) / (0.15 * 0.3 * 0.2 / 4.0);
    const double h = 1.0 / 60.0;
    double x = 0.01, v = 0.0;
    for (const double found : swings(implicit, x, 30)) {
      v = (v - h * w_squared * x) / (1.0 + h * damping_s * w_squared + h * h * w_squared);
      x += h * v;
      ASSERT_NEAR(found, x, 1e-10);
    }
  }
}

// The upper masses are pins that move up and down: their new velocity u pulls at the lower ones in the same step,
// v' = (v + h w^2 (e + h u)) / (1 + h^2 w^2) with the extension e.
TEST(Implicit, PinsThatAreLedPullWithTheVelocityTheyWillHave) {
  const Garment cell = make_garment(make_grid({.columns = 2, .rows = 2, .width_m = 0.3, .height_m = 0.2}));
  Surroundings led = vacuum(0.0);
  led.pin_motion = {{0.0, 0.02, 0.0}, 3.0};
  const ImplicitSettings implicit = {.stretch_n_per_m = 0.5, .damping_s = 0.0, .tolerance = exact};
  Simulation simulation(share(cell), {0, 1}, case_settings(implicit, 1), led);
  const double w_squared = (0.5 * 0.3 / (2.0 * 0.2)) / (0.15 * 0.3 * 0.2 / 4.0);
  const double h = 1.0 / 60.0;
  double pin = 0.0, x = 0.0, v = 0.0;
  for (int step = 0; step < 40; ++step) {
    const double moved = pin_displacement(led.pin_motion, {step * h, (step + 1) * h}).y;
    v = (v + h * w_squared * (pin - x + moved)) / (1.0 + h * h * w_squared);
    pin += moved;
    x += h * v;
    simulation.advance_frame();
    ASSERT_NEAR(simulation.state().current[2].y - cell.mesh.positions[2].y, x, 1e-9) << step;
  }
}

TEST(Implicit, AHangingStripStretchesByTheWeightBelow) {
  const double stiffness = 20.0;
  const Index rows = 11;
  const Garment strip =
      make_garment(make_grid({.columns = 4, .rows = rows, .width_m = 0.2, .height_m = 1.0}));
  Surroundings air = vacuum(9.81);
  air.forces.air_drag_per_s = 5.0;
  const ImplicitSettings implicit = {.stretch_n_per_m = stiffness, .shear_n_per_m = 10.0, .tolerance = 1e-10};
  Simulation simulation(share(strip), {0, 1, 2, 3}, case_settings(implicit), air);
  for (int frame = 0; frame < 400; ++frame) {
    simulation.advance_frame();
  }
  // Tension over k, with the weight of the rows below: in all g density length^2 / 2 k.
  for (Index row = 1; row < rows; ++row) {
    const double below_m = (rows - row - 0.5) / (rows - 1.0);
    const double expected_m = 0.1 * (1.0 + 0.15 * 9.81 * below_m / stiffness);
    for (Index column = 0; column < 4; ++column) {
      const auto& now = simulation.state().current;
      EXPECT_NEAR(now[4 * (row - 1) + column].y - now[4 * row + column].y, expected_m, 1e-7);
    }
  }
  const double grown_m = -simulation.state().current.back().y - 1.0;
  EXPECT_NEAR(grown_m, 9.81 * 0.15 * 1.0 / (2.0 * stiffness), 1e-6);
}

// Shear stiffness at half of the stretch's is alike in all directions: 45 degrees stretch as 0 do.
TEST(Implicit, OpposesAlikeInAllDirections) {
  const Garment cloth = make_garment(make_grid({.columns = 3, .rows = 3}));
  const auto energy = [&](double angle) {
    const Vec3 along = {std::cos(angle), std::sin(angle), 0.0};
    Positions stretched = cloth.mesh.positions;
    for (Vec3& p : stretched) {
      p += 1e-4 * along * glm::dot(along, p);
    }
    double sum = 0.0;
    for (const WovenTriangle& t : woven_triangles(cloth)) {
      sum += std::pow(stretch_condition(t, t.along_warp, stretched).value, 2) +
             std::pow(stretch_condition(t, t.along_weft, stretched).value, 2) +
             0.5 * std::pow(shear_condition(t, stretched).value, 2);
    }
    return sum;
  };
  EXPECT_NEAR(energy(0.0), 1e-8, 1e-11) << "of an area of 1 m2";
  EXPECT_NEAR(energy(std::numbers::pi / 4.0) / energy(0.0), 1.0, 1e-3);
  EXPECT_NEAR(energy(0.4) / energy(0.0), 1.0, 1e-3);
}

double elastic_energy_j(const Garment& garment, const ImplicitSettings& implicit, const Positions& now) {
  double energy = 0.0;
  for (const WovenTriangle& t : woven_triangles(garment)) {
    energy += 0.5 * implicit.stretch_n_per_m *
              (std::pow(stretch_condition(t, t.along_warp, now).value, 2) +
               std::pow(stretch_condition(t, t.along_weft, now).value, 2));
    energy += 0.5 * implicit.shear_n_per_m * std::pow(shear_condition(t, now).value, 2);
  }
  for (const Hinge& hinge : hinges(garment)) {
    energy += 0.5 * garment.material.bending_rigidity_n_m * hinge.shape *
              std::pow(bend_condition(hinge, now).value, 2);
  }
  return energy;
}

// The start is crumpled and stretched at random.
TEST(Implicit, NeverGainsEnergyWithoutForces) {
  const Garment cloth = make_garment(irregular_sheet(9, 0.5));
  std::mt19937 random(11);
  Positions start = cloth.mesh.positions;
  for (Vec3& p : start) {
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] += 0.02 * (static_cast<double>(random()) / 4294967296.0 - 0.5);
    }
  }
  const ImplicitSettings implicit = {.damping_s = 0.0, .tolerance = 1e-8};
  Simulation simulation(share(cloth), {}, case_settings(implicit), vacuum(0.0), start);
  double before_j = elastic_energy_j(cloth, implicit, start);
  for (int frame = 0; frame < 60; ++frame) {
    simulation.advance_frame();
    double energy_j = elastic_energy_j(cloth, implicit, simulation.state().current);
    for (Index v = 0; v < cloth.masses_kg.size(); ++v) {
      const Vec3 speed = velocity(simulation.state(), v);
      energy_j += 0.5 * cloth.masses_kg[v] * glm::dot(speed, speed);
    }
    ASSERT_LE(energy_j, before_j * (1.0 + 1e-9)) << frame;
    before_j = energy_j;
  }
}

TEST(Implicit, PinsStayOrMoveAsTheyAreLed) {
  const Garment cloth = make_garment(make_grid({}));
  Surroundings shaken;
  shaken.pin_motion = {{0.1, 0.0, 0.05}, 2.0};
  Simulation simulation(share(cloth), {0, 8}, case_settings({}), {});
  for (int frame = 0; frame < 30; ++frame) {
    simulation.advance_frame();
    EXPECT_EQ(simulation.state().current[8], cloth.mesh.positions[8]);
  }
  Simulation moved(share(cloth), {0, 8}, case_settings({}), shaken);
  for (int frame = 0; frame < 30; ++frame) {
    moved.advance_frame();
    const Vec3 offset = pin_displacement(shaken.pin_motion, {0.0, moved.state().time_s});
    EXPECT_NEAR(glm::distance(moved.state().current[8], cloth.mesh.positions[8] + offset), 0.0, 1e-12);
  }
  EXPECT_GT(glm::distance(moved.state().current[80], simulation.state().current[80]), 1e-3) << "drawn along";
}

// A stretched start springs back: steps are short at first, and whole frames again at the end.
TEST(Implicit, HalvesItsStepWhereStretchChangesAndDoublesItAgain) {
  const Garment cloth = make_garment(make_grid({}));
  Positions start = cloth.mesh.positions;
  for (Vec3& p : start) {
    p.y *= 1.6;
  }
  SimulationSettings settings = case_settings({.max_stretch_change = 0.05});
  settings.solver.max_substeps = 100;
  Simulation simulation(share(cloth), {0, 8}, settings, {}, start);
  simulation.advance_frame();
  const int most = simulation.frame_report().substeps;
  EXPECT_GE(most, 8);
  EXPECT_LE(most, 64) << "the largest power of 2 that is allowed";
  for (int frame = 0; frame < 60; ++frame) {
    simulation.advance_frame();
  }
  EXPECT_EQ(simulation.frame_report().substeps, 1);
  EXPECT_NEAR(simulation.state().time_s, 61.0 / 60.0, 1e-12);
}

// A checkpoint contains the last time step, which decides which steps are tried next.
TEST(Implicit, GoesOnWithTheStepItHad) {
  const Garment cloth = make_garment(make_grid({}));
  Positions start = cloth.mesh.positions;
  for (Vec3& p : start) {
    p.y *= 1.6;
  }
  const SimulationSettings settings = case_settings({.max_stretch_change = 0.05});
  Simulation simulation(share(cloth), {0, 8}, settings, {}, start);
  int shortened = 0;
  for (int frame = 0; frame < 12; ++frame) {
    simulation.advance_frame();
    Simulation other(share(cloth), {0, 8}, settings, {});
    other.restore(simulation.save());
    shortened += simulation.save().solver_memory.front() != 0 ? 1 : 0;
    simulation.advance_frame();
    other.advance_frame();
    EXPECT_EQ(hash(other.state()), hash(simulation.state())) << frame;
    EXPECT_EQ(other.frame_report(), simulation.frame_report()) << frame;
  }
  EXPECT_GT(shortened, 2);
}

TEST(Implicit, RefusesSettingsThatMakeNoSense) {
  for (const ImplicitSettings& wrong : {ImplicitSettings{.stretch_n_per_m = -1.0}, ImplicitSettings{.tolerance = 0.0},
                                        ImplicitSettings{.max_stretch_change = NAN}}) {
    EXPECT_THROW(make_solver({.method = wrong}), std::invalid_argument);
  }
  EXPECT_THROW(make_solver({.method = FastProjectionSettings{.max_projections = 0}}), std::invalid_argument);
  EXPECT_THROW(make_solver({.method = VassilevSettings{{}, -0.1}}), std::invalid_argument);
}

}  // namespace
}  // namespace taut::sim::implicit
