#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "app/report/verdicts.hpp"

namespace taut::app {
namespace {

constexpr Verdict yes = Verdict::holds;
constexpr Verdict partly = Verdict::holds_in_part;
constexpr Verdict no = Verdict::does_not_hold;

using Numbers = std::vector<double>;

TEST(Verdicts, TheBoundHoldsWhereEveryFrameKeepsIt) {
  using Runs = std::vector<StretchNumbers>;
  const StretchNumbers kept = {0.04, 0.05}, kept_at_end = {0.05, 0.3};
  EXPECT_EQ(judge_stretch_bound(Runs{kept, kept}), yes);
  EXPECT_EQ(judge_stretch_bound(Runs{kept, kept_at_end}), partly);
  EXPECT_EQ(judge_stretch_bound(Runs{kept, {0.051, 0.051}}), no) << "one run that does not keep it";
  EXPECT_EQ(judge_stretch_bound(Runs{{0.045, 0.067}, {8.48, 10.1}, {1.48, 2.1}, {0.46, 0.5}}), no);
  EXPECT_EQ(judge_stretch_bound(Runs{}), no) << "no run";
  for (const double lost : {NAN, INFINITY}) {
    EXPECT_EQ(judge_stretch_bound(Runs{kept, {0.04, lost}}), no) << "a number that is lost proves nothing";
    EXPECT_EQ(judge_stretch_bound(Runs{kept, {lost, 0.04}}), no);
  }
}

TEST(Verdicts, TheSurfaceIsFreeWhereItsStretchExceedsThatOfAllSprings) {
  using Runs = std::vector<SurfaceNumbers>;
  const SurfaceNumbers free = {0.05, {0.2, 0.06}}, at_worst = {0.05, {0.2, 0.054}},
                       held = {0.05, {0.054, 0.05}};
  EXPECT_EQ(judge_free_surface(Runs{free, free}), yes);
  EXPECT_EQ(judge_free_surface(Runs{free, at_worst}), partly);
  EXPECT_EQ(judge_free_surface(Runs{free, held}), no) << "no triangle is shorter than its edges";
  EXPECT_EQ(judge_free_surface(Runs{free, {0.05, {0.0, 0.06}}}), no);
  EXPECT_EQ(judge_free_surface(Runs{}), no);
  for (const double lost : {NAN, INFINITY}) {
    EXPECT_EQ(judge_free_surface(Runs{free, {lost, {lost, lost}}}), no) << "diverged";
    EXPECT_EQ(judge_free_surface(Runs{free, {0.05, {0.2, lost}}}), partly);
    EXPECT_EQ(judge_free_surface(Runs{free, {0.05, {lost, 0.2}}}), no);
  }
}

TEST(Verdicts, ConvergenceHoldsBelowAThousandthOfThePeak) {
  EXPECT_EQ(judge_convergence(1.0, 0.5, true), yes);
  EXPECT_EQ(judge_convergence(1.0, 9e-4, false), yes);
  EXPECT_EQ(judge_convergence(1.0, 2e-3, false), partly);
  EXPECT_EQ(judge_convergence(1.0, 0.2, false), no);
  EXPECT_EQ(judge_convergence(1.0, NAN, false), no);
}

// Bits are equal or not: there is no third verdict.
TEST(Verdicts, NoVelocityHoldsWhereBitsAreEqual) {
  EXPECT_EQ(judge_no_velocity(7, 7), yes);
  EXPECT_EQ(judge_no_velocity(7, 8), no);
}

TEST(Verdicts, RealTimeNeedsOneFastSettingOfEveryModel) {
  using Models = std::vector<PacedModel>;
  const PacedModel good = {1000, 16.6, 0.05}, slow = {1000, 16.7, 0.01}, torn = {1000, 4.0, 8.48};
  const auto of = [](PacedModel model, int triangles) {
    model.triangles = triangles;
    return model;
  };
  EXPECT_EQ(judge_real_time(Models{good, of(good, 2000)}), yes);
  EXPECT_EQ(judge_real_time(Models{good, slow, torn, of(torn, 2000), of(good, 2000)}), yes)
      << "one setting of a model is enough";
  EXPECT_EQ(judge_real_time(Models{good, of(good, 2000), of(slow, 3000), of(torn, 3000)}), partly);
  EXPECT_EQ(judge_real_time(Models{good, of(slow, 2000), of(torn, 3000)}), no) << "less than half";
  EXPECT_EQ(judge_real_time(Models{good, of(slow, 2000)}), no) << "just half";
  EXPECT_EQ(judge_real_time(Models{slow, torn}), no) << "fast and kept, but never both at once";
  EXPECT_EQ(judge_real_time(Models{{1000, 1.0, NAN}}), no);
  EXPECT_EQ(judge_real_time(Models{{1000, NAN, 0.01}}), no);
  EXPECT_EQ(judge_real_time(Models{}), no);
}

TimeGrowth growth_like(const std::function<double(double)>& time_ms) {
  std::vector<FrameTimes> times;
  for (const int triangles : model_sizes) {
    times.push_back({triangles, 1, 10, {1.5 * time_ms(triangles), time_ms(triangles)}});
  }
  return measure_growth(times, 1);
}

TEST(Verdicts, GrowthIsJudgedByTheLawThatFitsBest) {
  EXPECT_EQ(judge_growth(growth_like([](double n) { return 0.1 * std::exp(1e-3 * n); })), yes);
  EXPECT_EQ(judge_growth(growth_like([](double n) { return 1e-6 * n * n; })), partly);
  EXPECT_EQ(judge_growth(growth_like([](double n) { return 1e-6 * std::pow(n, 1.21); })), partly);
  EXPECT_EQ(judge_growth(growth_like([](double n) { return 1e-3 * std::pow(n, 1.03); })), no);
  EXPECT_EQ(judge_growth(growth_like([](double) { return 1.0; })), no) << "no growth at all";
  EXPECT_EQ(judge_growth({NAN, NAN, NAN}), no);
  EXPECT_EQ(judge_growth({2.0, NAN, NAN}), partly) << "no number says that it is geometric";
}

GarmentTrial trial_with(const Mapping& mapping, double stretch) {
  GarmentTrial trial;
  trial.mapping = mapping;
  trial.strong.largest_stretch = stretch;
  return trial;
}

TEST(Verdicts, AnyGarmentHoldsWhereAllAreMappedAndKeepTheBound) {
  using Trials = std::vector<GarmentTrial>;
  const Mapping good = {3, 1, 10, 10, 3, 0};
  const GarmentTrial kept = trial_with(good, 0.05);
  EXPECT_EQ(judge_any_garment(Trials{kept, kept}), yes);
  EXPECT_EQ(judge_any_garment(Trials{kept, trial_with(good, 0.051)}), partly);
  EXPECT_EQ(judge_any_garment(Trials{kept, trial_with(good, INFINITY)}), no) << "diverged";
  EXPECT_EQ(judge_any_garment(Trials{}), no);
  for (const Mapping& bad :
       {Mapping{3, 1, 10, 9, 3, 0}, {3, 1, 10, 10, 0, 0}, {3, 1, 10, 10, 3, 1}, Mapping{}}) {
    EXPECT_EQ(judge_any_garment(Trials{kept, trial_with(bad, 0.01)}), no);
  }
  GarmentTrial refused = kept;
  refused.refusal = "no reader knows this kind of file";
  EXPECT_EQ(judge_any_garment(Trials{kept, refused}), no);
}

TEST(Verdicts, TheThresholdVibratesWhereItsStepsDoAndStrongDoesNot) {
  const UnrestNumbers calm = {1e-5, 1e-5}, shaking = {1.0, 1.0}, late = {1e-5, 1.0}, early = {1.0, 1e-5};
  EXPECT_EQ(judge_threshold_vibrates(shaking, calm), yes);
  EXPECT_EQ(judge_threshold_vibrates(late, calm), partly);
  EXPECT_EQ(judge_threshold_vibrates(early, calm), partly);
  EXPECT_EQ(judge_threshold_vibrates(calm, calm), no);
  EXPECT_EQ(judge_threshold_vibrates(shaking, shaking), no);
  EXPECT_EQ(judge_threshold_vibrates({1e-5, INFINITY}, calm), partly) << "diverged is not calm";
  EXPECT_EQ(judge_threshold_vibrates(shaking, {INFINITY, NAN}), no);
}

TEST(Verdicts, IdealOverstretchesWhereAllExceedWhatStrongKeeps) {
  EXPECT_EQ(judge_ideal_overstretches(Numbers{0.078, 0.051, INFINITY}, 0.001), yes);
  EXPECT_EQ(judge_ideal_overstretches(Numbers{0.078, 0.02}, 0.001), partly);
  EXPECT_EQ(judge_ideal_overstretches(Numbers{0.05, 0.02}, 0.001), no);
  EXPECT_EQ(judge_ideal_overstretches(Numbers{0.078, 0.078}, 0.06), no) << "neither keeps it";
  EXPECT_EQ(judge_ideal_overstretches(Numbers{}, 0.001), no);
  EXPECT_EQ(judge_ideal_overstretches(Numbers{NAN}, 0.001), no);
  EXPECT_EQ(judge_ideal_overstretches(Numbers{0.078}, NAN), no);
}

TEST(Verdicts, FasterIsWhatOthersTakeLongerThanOnAllMeshes) {
  EXPECT_EQ(judge_faster(Numbers{2.0, 3.0}, 2.0), yes);
  EXPECT_EQ(judge_faster(Numbers{1.9, 3.0}, 2.0), partly);
  EXPECT_EQ(judge_faster(Numbers{1.9, 1.0}, 2.0), no);
  EXPECT_EQ(judge_faster(Numbers{INFINITY, NAN}, 1.0), no);
  EXPECT_EQ(judge_faster(Numbers{}, 1.0), no);
}

TEST(Verdicts, AThresholdIsBlamedForUnrestThatItsSpringsLack) {
  EXPECT_EQ(judge_threshold_unrest(0.011, 0.01), yes);
  EXPECT_EQ(judge_threshold_unrest(INFINITY, 0.01), yes) << "diverged is not calm";
  EXPECT_EQ(judge_threshold_unrest(0.005, 0.002), partly);
  EXPECT_EQ(judge_threshold_unrest(0.005, 0.003), no);
  EXPECT_EQ(judge_threshold_unrest(0.03, 0.02), no) << "the springs vibrate by themselves";
  EXPECT_EQ(judge_threshold_unrest(INFINITY, INFINITY), no);
}

TEST(Verdicts, NeighboursStretchWhereTheThresholdIsExceeded) {
  EXPECT_EQ(judge_neighbours_stretch(Numbers{1.06, 1.5}), yes);
  EXPECT_EQ(judge_neighbours_stretch(Numbers{1.06, 1.05}), partly);
  EXPECT_EQ(judge_neighbours_stretch(Numbers{0.2, 1.05}), no);
  EXPECT_EQ(judge_neighbours_stretch(Numbers{INFINITY}), no);
  EXPECT_EQ(judge_neighbours_stretch(Numbers{}), no);
}

TEST(Verdicts, StretchIsIgnoredWhereMoreThanHalfExceedTheBound) {
  EXPECT_EQ(judge_stretch_ignored(Numbers{0.06, 0.06, 0.01}), yes);
  EXPECT_EQ(judge_stretch_ignored(Numbers{0.06, 0.06, 0.01, 0.05}), partly) << "just half";
  EXPECT_EQ(judge_stretch_ignored(Numbers{0.05, INFINITY}), no) << "what is lost is not ignored";
  EXPECT_EQ(judge_stretch_ignored(Numbers{}), no);
}

TEST(Verdicts, RobustIsWhatKeepsTheBoundWithEveryStep) {
  EXPECT_EQ(judge_robust(Numbers{0.01, 0.05}), yes);
  EXPECT_EQ(judge_robust(Numbers{0.01, 0.06}), partly);
  EXPECT_EQ(judge_robust(Numbers{0.01, INFINITY}), no);
  EXPECT_EQ(judge_robust(Numbers{0.01, NAN}), no);
  EXPECT_EQ(judge_robust(Numbers{}), no);
}

}  // namespace
}  // namespace taut::app
