// Experiments that others published: each passes, and fails with physics that is wrong, most by a tenth.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/study/claims/rest_shapes.hpp"
#include "tests/study/claims/truth.hpp"

namespace taut::app {

void PrintTo(const TruthExperiment& experiment, std::ostream* out) { *out << experiment.name; }

namespace {

TEST(Truth, TheElasticaDroopsAsIsKnown) {
  // A stiff strip droops by w L^4 / (8 B); a limp one hangs straight down.
  EXPECT_NEAR(droop_of_elastica(0.08), 0.01, 1e-5);
  EXPECT_GT(droop_of_elastica(1000.0), 5.0);
}

TEST(Truth, ANarrowStripBucklesAsABeam) {
  // Bending is 8/9 and torsion 4/3 of the rigidity times the width, for a lateral contraction of 1/3.
  const double narrow = weight_that_buckles(0.02), wider = weight_that_buckles(0.05);
  EXPECT_NEAR(narrow - 0.02 * (wider - narrow) / 0.03, 12.85 * std::sqrt(8.0 / 9.0 * 4.0 / 3.0), 0.03);
}

TEST(Truth, AStripThatIsHardlyPressedSlipsAsAColumnDoes) {
  // The column's shape is ax - sin(ax) / cos(a) with tan a = a = 4.4934, which gives a friction of 2 sqrt(strain) / a.
  EXPECT_NEAR(friction_that_sticks(1e-3), 0.4451 * std::sqrt(1e-3), 1e-4);
}

TEST(Truth, ASheetHeldAtBothEndsFluttersAsAPanelDoes) {
  // Almost without the air's drag two modes meet at a load of 343.4, where both have a frequency of sqrt(1051.8) / 2
  // pi.
  const FlutterOnset panel = flutter_onset(1e-9, false);
  EXPECT_NEAR(panel.load, 343.36, 1.0);
  EXPECT_NEAR(panel.frequency, 5.162, 0.02);
}

class RestOfShirt : public testing::TestWithParam<int> {};

TEST_P(RestOfShirt, IsOfTheShirtOfTheScene) {
  const reference::RestCase shirt = reference::shirt(assets_folder() / "garments", GetParam());
  const LoadedGarment loaded = load_garment(shirt_scene("tshirt-gravity", GetParam()));
  const std::set<int> pins(loaded.pins.begin(), loaded.pins.end());
  EXPECT_EQ(std::set<int>(shirt.cloth.pins.begin(), shirt.cloth.pins.end()), pins);
  ASSERT_EQ(shirt.cloth.rest_m.size(), loaded.garment->mesh.positions.size());
  for (std::size_t v = 0; v < shirt.cloth.rest_m.size(); ++v) {
    const sim::Vec3& p = loaded.garment->mesh.positions[v];
    EXPECT_LT((shirt.cloth.rest_m[v] - reference::Point(p.x, p.y, p.z)).norm(), 1e-6);
  }
}

double mean_height_m(const reference::RestCase& what, const reference::Vector& shape) {
  return reference::measure_drape(reference::make_surface(what.cloth, shape),
                                  reference::Potential(what.cloth).masses_kg())
      .mean_m;
}

// A tenth of any force or stiffness moves the shirt by less than a millimetre, which its many shapes at rest hide.
TEST_P(RestOfShirt, HangsAsDeepAsByTheIncrementalPotential) {
  reference::RestCase shirt = reference::shirt(assets_folder() / "garments", GetParam());
  const double by_reference_m = mean_height_m(shirt, kept_rest(shirt));
  const double off_m = GetParam() < 5000 ? 0.004 : 0.0015;
  EXPECT_NEAR(mean_height_m(shirt, find_rest(shirt)), by_reference_m, off_m);
  shirt.cloth.gravity_m_per_s2 *= 2.0;
  EXPECT_LT(mean_height_m(shirt, find_rest(shirt)), by_reference_m - 1.2 * off_m);
}

INSTANTIATE_TEST_SUITE_P(Rests, RestOfShirt, testing::ValuesIn(reference::kept_shirts),
                         [](const auto& info) { return std::to_string(info.param); });

TEST(Rests, TheIncrementalPotentialComesBackFromTheShapeOnTheBall) {
  const reference::RestCase ball = reference::cloth_on_ball(28, 1e-3);
  const auto apart = [&](const reference::Vector& one, const reference::Vector& other) {
    return reference::difference(reference::make_surface(ball.cloth, one), reference::make_surface(ball.cloth, other));
  };
  const reference::Vector shape = find_rest(ball), kept = kept_rest(ball);
  EXPECT_LT(apart(shape, kept).hausdorff_m, 0.02);
  EXPECT_LT(apart(shape, kept).mean_m, 0.004);
  const reference::Vector from_there =
      reference::minimise(reference::Potential(ball.cloth), shape, {.max_force = 1e-3}).x;
  EXPECT_LT(apart(from_there, kept).hausdorff_m, 1e-4);
}

class Experiment : public testing::TestWithParam<TruthExperiment> {};

std::vector<TruthPoint> run(const TruthExperiment& experiment, double physics) {
  return experiment.run(experiment, physics, [](double) {});
}

double mean_measured(std::span<const TruthPoint> points) {
  double sum = 0.0;
  for (const TruthPoint& point : points) sum += point.measured;
  return sum / static_cast<double>(points.size());
}

/// Returns true if the deviation is within its tolerance or, for an experiment that does not pass, as known.
bool is_as_known(const TruthExperiment& experiment, double physics) {
  const std::vector<TruthPoint> points = run(experiment, physics);
  const Deviation deviation = compute_deviation(experiment, points);
  EXPECT_GE(deviation.points, 6U);
  if (experiment.mean > 0.0 && std::abs(mean_measured(points) / experiment.mean - 1.0) > 0.02) return false;
  if (experiment.known == 0.0) return deviation.largest() <= experiment.tolerance;
  return std::abs(deviation.worst - experiment.known) < 0.15 * std::abs(experiment.known);
}

TEST_P(Experiment, AgreesWithWhatIsPublishedAsFarAsIsKnown) {
  EXPECT_TRUE(is_as_known(GetParam(), 1.0)) << compute_deviation(GetParam(), run(GetParam(), 1.0)).worst;
}

TEST_P(Experiment, DoesNotWhereThePhysicsIsWrong) {
  const TruthExperiment& experiment = GetParam();
  EXPECT_FALSE(is_as_known(experiment, experiment.wrong));
  // Smaller physics cannot break an upper limit.
  if (experiment.measure == Measure::excess) return;
  EXPECT_FALSE(is_as_known(experiment, 1.0 / experiment.wrong));
}

INSTANTIATE_TEST_SUITE_P(Truth, Experiment, testing::ValuesIn(truth_experiments()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace taut::app
