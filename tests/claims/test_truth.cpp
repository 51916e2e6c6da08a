// Experiments that others published: each passes, and fails with physics that is wrong by a tenth.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/claims/truth.hpp"

namespace taut::app {

void PrintTo(const TruthExperiment& experiment, std::ostream* out) { *out << experiment.name; }

namespace {

TEST(Truth, TheElasticaDroopsAsIsKnown) {
  // A stiff strip droops by w L^4 / (8 B), a limp one hangs down.
  EXPECT_NEAR(droop_of_elastica(0.08), 0.01, 1e-5);
  EXPECT_GT(droop_of_elastica(1000.0), 5.0);
}

TEST(Truth, ANarrowStripBucklesAsABeam) {
  // Bending 8/9 and torsion 4/3 of the rigidity times the width, for a lateral contraction of 1/3.
  const double narrow = weight_that_buckles(0.02), wider = weight_that_buckles(0.05);
  EXPECT_NEAR(narrow - 0.02 * (wider - narrow) / 0.03, 12.85 * std::sqrt(8.0 / 9.0 * 4.0 / 3.0), 0.03);
}

TEST(Truth, AStripThatIsHardlyPressedSlipsAsAColumnDoes) {
  // The column's shape is ax - sin(ax) / cos(a) with tan a = a = 4.4934: a friction of 2 sqrt(strain) / a.
  EXPECT_NEAR(friction_that_sticks(1e-3), 0.4451 * std::sqrt(1e-3), 1e-4);
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

/// Whether the deviation is what it may be, or where the experiment does not pass, what it is known to be.
bool is_as_known(const TruthExperiment& experiment, double physics) {
  const std::vector<TruthPoint> points = run(experiment, physics);
  const Deviation deviation = deviation_of(experiment, points);
  EXPECT_GE(deviation.points, 12U);
  if (experiment.mean > 0.0 && std::abs(mean_measured(points) / experiment.mean - 1.0) > 0.02) return false;
  if (experiment.known == 0.0) return deviation.largest() <= experiment.tolerance;
  return std::abs(deviation.worst - experiment.known) < 0.15 * std::abs(experiment.known);
}

TEST_P(Experiment, AgreesWithWhatIsPublishedAsFarAsIsKnown) {
  EXPECT_TRUE(is_as_known(GetParam(), 1.0)) << deviation_of(GetParam(), run(GetParam(), 1.0)).worst;
}

TEST_P(Experiment, DoesNotWhereThePhysicsIsWrongByATenth) {
  const TruthExperiment& experiment = GetParam();
  EXPECT_FALSE(is_as_known(experiment, 1.1));
  // An upper limit is not broken from below.
  if (experiment.measure == Measure::excess) return;
  EXPECT_FALSE(is_as_known(experiment, 1.0 / 1.1));
}

INSTANTIATE_TEST_SUITE_P(Truth, Experiment, testing::ValuesIn(truth_experiments()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace taut::app
