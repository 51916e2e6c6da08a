// Experiments that others published: each passes, and fails with physics that is wrong by a tenth.

#include <gtest/gtest.h>

#include "tests/claims/truth.hpp"

namespace taut::app {

void PrintTo(const TruthExperiment& experiment, std::ostream* out) { *out << experiment.name; }

namespace {

TEST(Truth, TheElasticaDroopsAsIsKnown) {
  // A stiff strip droops by w L^4 / (8 B), a limp one hangs down.
  EXPECT_NEAR(droop_of_elastica(0.08), 0.01, 1e-5);
  EXPECT_GT(droop_of_elastica(1000.0), 5.0);
}

class Experiment : public testing::TestWithParam<TruthExperiment> {};

std::vector<TruthPoint> run(const TruthExperiment& experiment, double physics) {
  return experiment.run(experiment, physics, [](double) {});
}

/// Whether the deviation is what it may be, or where the experiment does not pass, what it is known to be.
bool is_as_known(const TruthExperiment& experiment, double physics) {
  const Deviation deviation = deviation_of(experiment, run(experiment, physics));
  EXPECT_GE(deviation.points, 15U);
  if (experiment.known == 0.0) return deviation.largest() <= experiment.tolerance;
  return std::abs(deviation.worst - experiment.known) < 0.15 * std::abs(experiment.known);
}

TEST_P(Experiment, AgreesWithWhatIsPublishedAsFarAsIsKnown) {
  EXPECT_TRUE(is_as_known(GetParam(), 1.0)) << deviation_of(GetParam(), run(GetParam(), 1.0)).worst;
}

TEST_P(Experiment, DoesNotWhereThePhysicsIsWrongByATenth) {
  const TruthExperiment& experiment = GetParam();
  if (experiment.measure == Measure::excess) GTEST_SKIP() << "a limit, which no law decides";
  if (std::abs(experiment.known) > 0.5) GTEST_SKIP() << "it is wrong by more";
  for (const double physics : {1.0 / 1.1, 1.1}) EXPECT_FALSE(is_as_known(experiment, physics)) << physics;
}

INSTANTIATE_TEST_SUITE_P(Truth, Experiment, testing::ValuesIn(truth_experiments()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace taut::app
