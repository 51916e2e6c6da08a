// Tests of the incremental potential: its derivatives, closed forms, and the stored shapes at rest.

#include <gtest/gtest.h>

#include <random>

#include "tests/study/reference/cases.hpp"
#include "tests/study/reference/measures.hpp"

namespace reference {

void PrintTo(const RestCase& what, std::ostream* out) { *out << what.name; }

namespace {

using Term = std::function<Local(const Vector&)>;

/// Largest errors of both derivatives, as fractions of their largest entries.
struct Errors {
  double gradient = 0.0, hessian = 0.0;
};

Errors derivative_errors(const Term& term, const Vector& x) {
  constexpr double step = 3e-8;
  const Local local = term(x);
  const int n = 3 * local.count;
  Eigen::VectorXd gradient(n);
  Eigen::MatrixXd hessian(n, n);
  for (int k = 0; k < n; ++k) {
    Vector ahead = x, behind = x;
    ahead[3 * local.vertices[k / 3] + k % 3] += step;
    behind[3 * local.vertices[k / 3] + k % 3] -= step;
    const Local after = term(ahead), before = term(behind);
    gradient[k] = (after.energy - before.energy) / (2.0 * step);
    hessian.col(k) = (after.gradient - before.gradient).head(n) / (2.0 * step);
  }
  const double first = local.gradient.head(n).cwiseAbs().maxCoeff();
  const double second = local.hessian.topLeftCorner(n, n).cwiseAbs().maxCoeff();
  if (!(first > 0.0)) return {};
  return {(local.gradient.head(n) - gradient).cwiseAbs().maxCoeff() / first,
          (local.hessian.topLeftCorner(n, n) - hessian).cwiseAbs().maxCoeff() / second};
}

TEST(Reference, DerivativesAreThoseOfTheEnergies) {
  std::mt19937 bits(3);
  std::normal_distribution<double> normal(0.0, 0.03);
  const auto point = [&] { return Point(normal(bits), normal(bits), normal(bits)); };
  const Potential potential({{point(), point(), point(), point()}, {{0, 1, 2}, {1, 0, 3}}, {}, {0.2, 1e3, 1e-4, 0.05}});
  int in_reach = 0;
  for (int i = 0; i < 20; ++i) {
    const Vector x = flatten({point(), point(), point(), point()});
    const auto of_pair = [&](bool is_of_edges, double parallel_below_m4) {
      return Term([=, &potential](const Vector& y) {
        return potential.barrier_of(y, {{0, 1, 2, 3}, is_of_edges, 1e-3, parallel_below_m4});
      });
    };
    const std::array<Term, 5> terms = {[&](const Vector& y) { return potential.stretch_of(y, 0); },
                                       [&](const Vector& y) { return potential.bend_of(y, 0); }, of_pair(false, 0.0),
                                       of_pair(true, 0.0), of_pair(true, 1e-5)};
    for (std::size_t t = 0; t < terms.size(); ++t) {
      const Errors errors = derivative_errors(terms[t], x);
      EXPECT_LT(errors.gradient, 1e-5) << t;
      EXPECT_LT(errors.hessian, 1e-4) << t;
      in_reach += t > 1 && terms[t](x).energy > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(in_reach, 10);
}

TEST(Reference, AStepLetsNothingTouch) {
  const Pair edges = {{0, 1, 2, 3}, true};
  const std::array<Point, 4> x = {Point(-1, 0, 0), Point(1, 0, 0), Point(0, 1, -1), Point(0, 1, 1)};
  const Point down(0, -3, 0), none = Point::Zero();
  const double part = step_that_keeps_apart(edges, x, {none, none, down, down});
  EXPECT_LT(part, 1.0 / 3.0);
  EXPECT_GT(part, 0.8 / 3.0);
  EXPECT_EQ(step_that_keeps_apart(edges, x, {none, none, -down, -down}), 1.0);
  EXPECT_EQ(step_that_keeps_apart(edges, x, {none, none, 0.2 * down, 0.2 * down}), 1.0);
}

/// Returns a level strip of 10 cm by 3 cm whose first rows are clamped.
Cloth strip(const Fabric& fabric) {
  constexpr int across = 8, rows = 32, clamped_rows = 2;
  constexpr double row_m = 0.1 / (rows - clamped_rows);
  const Surface sheet = even_sheet(across, rows, 0.03, row_m * rows);
  Cloth cloth{sheet.points_m, sheet.triangles, {}, fabric};
  for (Point& p : cloth.rest_m) p.z() += 0.05 - row_m * clamped_rows / 2.0;
  for (int v = 0; v < static_cast<int>(cloth.rest_m.size()); ++v) {
    if (cloth.rest_m[v].z() < 1e-9) cloth.pins.push_back(v);
  }
  return cloth;
}

Point end_position(const Cloth& cloth) {
  const Rest rest = minimise(Potential(cloth), flatten(cloth.rest_m), {.max_force = 1e-3});
  EXPECT_TRUE(rest.is_stable);
  EXPECT_LE(rest.max_force, 1e-3);
  return at(rest.x, static_cast<int>(cloth.rest_m.size()) - 5);
}

TEST(Reference, AClampedStripDroopsAsTheElastica) {
  // Weight times length^3 over rigidity, and drop over reach of the heavy elastica (Bickley 1934) with 8/9 of the
  // rigidity: hinges of equilateral triangles bend as a plate with a lateral contraction of -1/3, and a strip has 1 -
  // 1/9 of a plate's rigidity.
  for (const auto& [load, droop] : std::array<std::array<double, 2>, 2>{{{3.0, 0.40760}, {16.0, 1.71576}}}) {
    Fabric fabric{0.25, 2e3, 0.25 * 9.81 * 1e-3 / load, 1e-3};
    const auto droops = [&] {
      const Point end = end_position(strip(fabric));
      return -end.y() / end.z();
    };
    EXPECT_NEAR(droops() / droop, 1.0, 0.02) << load;
    fabric.rigidity_n_m *= 1.1;
    EXPECT_LT(droops() / droop, 0.95) << load;
  }
}

TEST(Reference, AHangingStripStretchesByItsWeight) {
  Cloth cloth = strip({0.25, 100.0, 1e-6, 1e-3});
  for (Point& p : cloth.rest_m) p = Point(p.x(), -p.z(), 0.0);
  // Expected extension: weight w L^2 / 2 over the stiffness.
  EXPECT_NEAR(-end_position(cloth).y() - 0.1, 0.25 * 9.81 * 0.01 / 2.0 / 100.0, 3e-6);
}

TEST(Reference, ShapesAreAsFarApartAsTheyAre) {
  const Surface square = {{{0, 0, 0}, {0.1, 0, 0}, {0.1, 0, 0.1}, {0, 0, 0.1}}, {{0, 1, 2}, {0, 2, 3}}};
  Surface other = square;
  for (Point& p : other.points_m) p += Point(0.03, 0.04, 0.0);
  const Difference apart = difference(square, other);
  EXPECT_NEAR(apart.hausdorff_m, 0.05, 1e-12);
  EXPECT_NEAR(apart.mean_m, std::sqrt((0.0016 + 0.0025) / 2.0), 1e-12);
  EXPECT_NEAR(apart.vertices_m, 0.05, 1e-12);
  const Drape drape = measure_drape(other, {1.0, 1.0, 1.0, 1.0});
  EXPECT_NEAR(drape.shadow_m2, 0.01, 3e-4);
  EXPECT_NEAR(drape.min_height_m, 0.04, 1e-12);
}

class KeptShape : public testing::TestWithParam<RestCase> {};

TEST_P(KeptShape, IsAtRest) {
  const RestCase& what = GetParam();
  const Vector kept = kept_rest(what, TAUT_REFERENCE_SHAPES);
  const Rest rest = minimise(Potential(what.cloth), kept, {.max_force = 1e-3, .max_steps = 0});
  EXPECT_LT(rest.max_force, 1e-3);
  EXPECT_TRUE(rest.is_stable);
  Vector moved = kept;
  const int free = std::find(what.cloth.pins.begin(), what.cloth.pins.end(), 0) == what.cloth.pins.end() ? 0 : 1;
  moved[3 * free] += 1e-5;
  EXPECT_GT(max_force(Potential(what.cloth), moved), 0.1);
}

TEST_P(KeptShape, IsNotWhereThePhysicsIsWrongByATenth) {
  const RestCase& what = GetParam();
  const Vector kept = kept_rest(what, TAUT_REFERENCE_SHAPES);
  const auto force = [&](auto change) {
    Cloth cloth = what.cloth;
    change(cloth);
    return max_force(Potential(std::move(cloth)), kept);
  };
  EXPECT_GT(force([](Cloth& cloth) { cloth.gravity_m_per_s2 *= 1.1; }), 0.05);
  EXPECT_GT(force([](Cloth& cloth) { cloth.fabric.stiffness_n_per_m *= 1.1; }), 0.05);
  EXPECT_GT(force([](Cloth& cloth) { cloth.fabric.rigidity_n_m *= 1.1; }), 0.05);
}

INSTANTIATE_TEST_SUITE_P(All, KeptShape, testing::ValuesIn(kept_cases(TAUT_GARMENTS)),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace reference
