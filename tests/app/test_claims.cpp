#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/report/report.hpp"

namespace taut::app {
namespace {

constexpr Verdict yes = Verdict::holds;
constexpr Verdict partly = Verdict::holds_with_condition;
constexpr Verdict no = Verdict::does_not_hold;

using Numbers = std::vector<double>;

TEST(Verdicts, StretchBound) {
  const StretchNumbers kept = {0.04, 0.05}, kept_at_end = {0.05, 0.1};
  using Runs = std::vector<StretchNumbers>;
  EXPECT_EQ(judge_stretch_bound(Runs{kept, kept}, Numbers{0.01, 0.05}), yes);
  EXPECT_EQ(judge_stretch_bound(Runs{kept, kept}, Numbers{8.4, 0.04}), partly);
  EXPECT_EQ(judge_stretch_bound(Runs{kept, kept_at_end}, Numbers{0.01}), partly);
  EXPECT_EQ(judge_stretch_bound(Runs{kept, {0.051, 0.051}}, Numbers{0.01}), no);
  EXPECT_EQ(judge_stretch_bound(Runs{kept, {0.04, 0.11}}, Numbers{0.01}), no) << "far beyond on the way";
  EXPECT_EQ(judge_stretch_bound(Runs{kept, {0.04, NAN}}, Numbers{0.01}), no)
      << "a number that is lost proves nothing";
}

TEST(Verdicts, Convergence) {
  EXPECT_EQ(judge_convergence(1.0, 0.5, true), yes);
  EXPECT_EQ(judge_convergence(1.0, 9e-4, false), yes);
  EXPECT_EQ(judge_convergence(1.0, 2e-3, false), partly);
  EXPECT_EQ(judge_convergence(1.0, 0.2, false), no);
}

TEST(Verdicts, NoVelocity) {
  EXPECT_EQ(judge_no_velocity(7, 7), yes);
  EXPECT_EQ(judge_no_velocity(7, 8), no);
}

TEST(Verdicts, RealTime) {
  EXPECT_EQ(judge_real_time(Numbers{1.0, 16.6}, Numbers{2.0}), yes);
  EXPECT_EQ(judge_real_time(Numbers{1.0}, Numbers{2.0, 17.0}), partly);
  EXPECT_EQ(judge_real_time(Numbers{17.0}, Numbers{2.0}), partly);
  EXPECT_EQ(judge_real_time(Numbers{17.0}, Numbers{170.0}), no);
}

TEST(Verdicts, Growth) {
  EXPECT_EQ(judge_growth(2.0), yes);
  EXPECT_EQ(judge_growth(1.21), yes);
  EXPECT_EQ(judge_growth(1.2), partly);
  EXPECT_EQ(judge_growth(0.8), partly);
  EXPECT_EQ(judge_growth(0.5), no);
  EXPECT_EQ(judge_growth(NAN), no);
}

TEST(Verdicts, Mapping) {
  const MappingNumbers good = {10, 10, 3, 0};
  EXPECT_EQ(judge_mapping(std::vector{good, good}), yes);
  EXPECT_EQ(judge_mapping(std::vector<MappingNumbers>{}), no);
  for (const MappingNumbers& bad : {MappingNumbers{10, 9, 3, 0}, {10, 10, 0, 0}, {10, 10, 3, 1}}) {
    EXPECT_EQ(judge_mapping(std::vector{good, bad}), no);
  }
}

TEST(Verdicts, ThresholdVibrates) {
  const UnrestNumbers calm = {1e-5, 1e-5}, shaking = {1.0, 1.0}, late = {1e-5, 1.0}, early = {1.0, 1e-5};
  EXPECT_EQ(judge_threshold_vibrates(shaking, calm), yes);
  EXPECT_EQ(judge_threshold_vibrates(late, calm), partly);
  EXPECT_EQ(judge_threshold_vibrates(early, calm), partly);
  EXPECT_EQ(judge_threshold_vibrates(calm, calm), no);
  EXPECT_EQ(judge_threshold_vibrates(shaking, shaking), no);
  EXPECT_EQ(judge_threshold_vibrates({1e-5, INFINITY}, calm), partly) << "diverged is not calm";
  EXPECT_EQ(judge_threshold_vibrates(shaking, {INFINITY, NAN}), no);
}

TEST(Verdicts, IdealOverstretches) {
  EXPECT_EQ(judge_ideal_overstretches(0.078, 0.001), partly);
  EXPECT_EQ(judge_ideal_overstretches(0.04, 0.001), no);
  EXPECT_EQ(judge_ideal_overstretches(0.078, 0.06), no);
}

Recording recording_at(double stretch) {
  Recording recording;
  recording.moments.resize(1);
  recording.moments[0].record.stretch.max = stretch;
  recording.largest_stretch = stretch;
  return recording;
}

Results made_up_results() {
  Results results;
  results.fall.emplace();
  results.fall->moved_m = {1.0, 1e-6};
  results.pinned = {recording_at(0.04), recording_at(0.19)};
  results.shirts = {recording_at(0.03), recording_at(0.03), recording_at(0.04)};
  results.sweeps = {{{10, 8.0, 9.0}, {50, 1.0, 1.0}, {200, 0.4, 0.5}}};
  results.restart = {5, 5, 30, 60};
  results.models = {{"a.obj", 3, 1, 3, 3, 1, 0}};
  for (const int substeps : {1, 100}) {
    for (const int triangles : {1000, 10000}) {
      results.frame_times.push_back({triangles, substeps, 1, {triangles * substeps * 1e-3}});
    }
  }
  for (const double step_s : {0.001, 0.01}) {
    for (const sim::SolverKind kind : compared_methods) {
      const double moved_m = kind == sim::SolverKind::provot && step_s > 0.005 ? 0.01 : 1e-9;
      results.methods.push_back(
          {kind, step_s, {kind == sim::SolverKind::strong ? 0.01 : 0.08}, {moved_m}, {}});
    }
  }
  results.methods[3].diverged_at_s = 1.0;
  return results;
}

Verdict verdict_of(const Results& results, const std::string& id) {
  for (const Claim& claim : judge_claims(results)) {
    if (claim.text.id == id) {
      return claim.judgement.verdict;
    }
  }
  throw std::invalid_argument(id);
}

TEST(Claims, VerdictsComeFromTheNumbers) {
  Results results = made_up_results();
  EXPECT_EQ(verdict_of(results, "stretch-bound"), partly);
  EXPECT_EQ(verdict_of(results, "convergence"), yes);
  EXPECT_EQ(verdict_of(results, "no-velocity"), yes);
  EXPECT_EQ(verdict_of(results, "real-time"), partly);
  EXPECT_EQ(verdict_of(results, "growth"), partly);
  EXPECT_EQ(verdict_of(results, "any-garment"), yes);
  EXPECT_EQ(verdict_of(results, "threshold-vibrates"), partly);
  EXPECT_EQ(verdict_of(results, "ideal-overstretches"), partly);

  results.pinned[0]->moments[0].record.stretch.max = 0.06;
  results.fall->moved_m = {1.0, 0.9};
  results.restart.restarted_hash = 6;
  for (FrameTimes& time : results.frame_times) {
    time.frame_ms = {1e6};
  }
  results.models[0].loose_vertices = 1;
  results.methods[4].moved_rms_m = {1e-9};
  results.methods[0].max_stretch = {0.01};
  for (const Claim& claim : judge_claims(results)) {
    EXPECT_EQ(claim.judgement.verdict, no) << claim.text.id;
    EXPECT_EQ(claim.judgement.condition, "") << claim.text.id;
  }
}

TEST(Claims, FindingsSayTheNumbersThatDecide) {
  Results results = made_up_results();
  results.pinned[0]->largest_stretch = 0.067;
  for (const Claim& claim : judge_claims(results)) {
    EXPECT_EQ(claim.judgement.condition.empty(), claim.judgement.verdict != partly) << claim.text.id;
    if (claim.text.id == "stretch-bound") {
      EXPECT_NE(claim.judgement.finding.find("6.7 %"), std::string::npos) << claim.judgement.finding;
      EXPECT_NE(claim.judgement.finding.find("800 %"), std::string::npos) << claim.judgement.finding;
    }
  }
}

TEST(Claims, NumbersAreWrittenAsPeopleDo) {
  const auto text = [](double value, int digits) { return number_text({"", value, "m", digits}); };
  EXPECT_EQ(text(6.0755e-7, 3), "6.08 × 10⁻⁷ m");
  EXPECT_EQ(text(848.13, 2), "848 m");
  EXPECT_EQ(text(26.97, 3), "27.0 m");
  EXPECT_EQ(text(0.0042410, 3), "0.00424 m");
  EXPECT_EQ(text(-19282.0, 6), "-19282 m");
  EXPECT_EQ(number_text({"", INFINITY, "m"}), "diverged");
}

TEST(Claims, JsonIsCompleteEvenWhereARunDiverged) {
  Results results = made_up_results();
  results.methods[4].diverged_at_s = 0.5;
  Machine machine;
  machine.processor = "a \"quoted\" one";
  const auto json = nlohmann::json::parse(claims_json(judge_claims(results), machine));
  EXPECT_EQ(json["machine"]["processor"], "a \"quoted\" one");
  EXPECT_TRUE(json["versions"].contains("compiler"));
  ASSERT_GE(json["claims"].size(), 7U);
  bool has_null = false;
  for (const auto& claim : json["claims"]) {
    for (const char* key : {"id", "section", "claim", "test", "threshold", "measured", "verdict", "condition",
                            "finding", "remark"}) {
      EXPECT_TRUE(claim.contains(key)) << key;
    }
    const std::string verdict = claim["verdict"];
    EXPECT_TRUE(verdict == name_of(yes) || verdict == name_of(partly) || verdict == name_of(no)) << verdict;
    EXPECT_FALSE(claim["measured"].empty());
    for (const auto& number : claim["measured"]) {
      has_null = has_null || number["value"].is_null();
    }
  }
  EXPECT_TRUE(has_null);
}

TEST(Report, IsOneFileWithPicturesInside) {
  renderer::Image picture = renderer::make_image(40, 20);
  const std::vector<DrawnFigure> figures = {{"fig1", "A & B", picture}};
  const std::string html = report_html(judge_claims(made_up_results()), figures, {});
  EXPECT_NE(html.find("src=\"data:image/png;base64,iVBOR"), std::string::npos);
  EXPECT_NE(html.find("A &amp; B"), std::string::npos);
  EXPECT_NE(html.find("holds with a condition"), std::string::npos);
  EXPECT_EQ(html.find("http"), std::string::npos) << "nothing from elsewhere";
  EXPECT_EQ(contact_sheet(figures).width_px, 2560);
}

TEST(Report, Base64) {
  const std::string text = "Man is";
  const auto encoded = [&](std::size_t count) {
    return base64(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), count));
  };
  EXPECT_EQ(encoded(0), "");
  EXPECT_EQ(encoded(1), "TQ==");
  EXPECT_EQ(encoded(2), "TWE=");
  EXPECT_EQ(encoded(3), "TWFu");
  EXPECT_EQ(encoded(6), "TWFuIGlz");
}

}  // namespace
}  // namespace taut::app
