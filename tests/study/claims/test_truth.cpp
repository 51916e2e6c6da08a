// Experiments that others published: each passes, and fails with physics that is wrong, most by a tenth.

#include <gtest/gtest.h>

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

TEST(TruthTable, SaysInWordsWhatDoesNotPass) {
  TruthExperiment experiment;
  experiment.name = "droop";
  experiment.tolerance = 0.1;
  const auto row = [&](double measured) {
    return truth_html({&experiment, 1}, std::array{TruthPoint{"", 0.0, measured, 1.0, NAN, "9 x 33", "droop"}});
  };
  EXPECT_NE(row(1.05).find("<b>passes</b>"), std::string::npos);
  EXPECT_NE(row(1.2).find("<b>does not pass</b></td>"), std::string::npos);
  experiment.known = 0.2;
  EXPECT_NE(row(1.2).find("<b>does not pass</b>, a known flaw</td>"), std::string::npos);
}

class Experiment : public testing::TestWithParam<TruthExperiment> {};

std::vector<TruthPoint> run(const TruthExperiment& experiment, double physics) {
  return run_experiment(experiment, physics, [](double) {});
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
