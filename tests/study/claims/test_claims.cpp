#include <gtest/gtest.h>

#include "app/base/words.hpp"
#include "study/claims/made_trials.hpp"
#include "temporary_folder.hpp"
#include "tests/study/claims/report.hpp"

namespace taut::app {
namespace {

constexpr Verdict yes = Verdict::holds;
constexpr Verdict partly = Verdict::holds_in_part;
constexpr Verdict no = Verdict::does_not_hold;

GarmentTrial trial_with(const Mapping& mapping, double stretch) {
  GarmentTrial trial;
  trial.file = "a.obj";
  trial.kind = "of its kind";
  trial.mapping = mapping;
  trial.strong.max_stretch_seen = stretch;
  trial.bounded = {0.04, 1.0};
  return trial;
}

Recording recording_at(double stretch) {
  Recording recording;
  recording.moments.resize(1);
  recording.moments[0].record.stretch.max = stretch;
  recording.max_stretch_seen = stretch;
  recording.max_surface_stretch = {4.0 * stretch, 1.5 * stretch};
  return recording;
}

// Results for which every claim holds.
ClaimResults results_of_the_paper() {
  ClaimResults results;
  results.fall.emplace();
  results.fall->moved_m = {1.0, 1e-6};
  results.pinned = {recording_at(0.04), recording_at(0.19)};
  results.shirts = {recording_at(0.0097), recording_at(0.0098), recording_at(0.0099)};
  results.strong_runs = {{"shirt", false, 1, 10, {0.03, 0.04}, {0.2, 0.05}},
                         {"shirt", true, 100, 1, {0.02, 0.03}, {0.1, 0.04}}};
  results.restart = {5, 5, 30, 60};
  results.garments = {trial_with({3, 1, 3, 3, 1, 0}, 0.04)};
  for (const int triangles : model_sizes) {
    for (const int substeps : {1, 100}) {
      results.frame_times.push_back({triangles, substeps, 1, {1e-3 * std::exp(9e-4 * triangles)}, 0.04});
    }
    results.bounded_times.push_back({triangles, 0, 0, {1e-3 * triangles}, 0.01});
  }
  for (const double step_s : {0.001, 0.01}) {
    for (const sim::SolverKind kind : compared_methods) {
      const double moved_m = kind == sim::SolverKind::provot ? 0.1 : 1e-9;
      const double stretch = kind == sim::SolverKind::strong ? 0.01 : 0.08;
      results.methods.push_back({kind, step_s, {stretch}, {moved_m}, {}});
    }
  }
  for (const double stiffness_n_per_m : {50.0, 100.0}) {
    results.ideal_stiffnesses.push_back({sim::SolverKind::ideal, 0.001, {0.08}, {1e-9}, {}, stiffness_n_per_m});
  }
  test::make_up_trials(results);
  return results;
}

using enum sim::SolverKind;

using test::trial_in;

ClaimResults results_in_part() {
  ClaimResults results = results_of_the_paper();
  results.pinned[0]->max_stretch_seen = 0.067;
  results.strong_runs[0].surface = {0.2, 0.01};
  results.fall->moved_m = {1.0, 0.05};
  results.garments.push_back(trial_with({3, 1, 3, 3, 1, 0}, 0.2));
  for (FrameTimes& time : results.frame_times) {
    time.frame_ms = {1.5e-7 * time.triangles * time.triangles};
    time.max_stretch_seen = time.triangles > 10000 ? 0.3 : 0.01;
  }
  results.methods[1].moved_rms_m = {1e-9};
  results.ideal_stiffnesses[1].max_stretch = {0.04};
  trial_in(results, MethodTest::time, implicit).frames = {{0.1, 10.0, 0.1}};
  trial_in(results, MethodTest::time, strong).frames = {{0.1, 20.0, 0.01}};
  trial_in(results, MethodTest::time, fast_projection).frames = {{0.1, 10.0, 0.005}, {0.2, 10.0, 0.005}};
  for (TrialFrame& frame : trial_in(results, MethodTest::rest, vassilev).frames) frame.speed_m_per_s = 0.005;
  for (const sim::SolverKind kind : {vassilev, implicit}) {
    trial_in(results, MethodTest::time, kind, 10600).frames = {{0.1, 10.0, 0.04}};
  }
  trial_in(results, MethodTest::steps, strong).frames[1].stretch = 0.06;
  return results;
}

ClaimResults results_against_it() {
  ClaimResults results = results_of_the_paper();
  results.strong_runs[0].stretch = {8.48, 10.1};
  results.fall->moved_m = {1.0, 0.9};
  results.restart.restarted_hash = 6;
  results.garments[0].mapping.loose_vertices = 1;
  for (FrameTimes& time : results.frame_times) {
    time.frame_ms = {time.substeps * 1e-3 * time.triangles};
    time.max_stretch_seen = time.substeps == 1 ? 8.48 : 0.04;
  }
  results.methods[4].moved_rms_m = results.methods[1].moved_rms_m = {1e-9};
  results.ideal_stiffnesses[0].max_stretch = results.ideal_stiffnesses[1].max_stretch = {0.04};
  for (MethodTrial& timed : results.trials_of(MethodTest::time)) {
    for (TrialFrame& frame : timed.frames) {
      frame.frame_ms = timed.kind == strong ? 20.0 : 10.0;
      frame.stretch = 0.01;
    }
  }
  trial_in(results, MethodTest::rest, vassilev).frames = trial_in(results, MethodTest::rest, ideal).frames;
  trial_in(results, MethodTest::steps, strong).is_lost = true;
  return results;
}

const Claim& find_claim(const std::vector<Claim>& claims, const std::string& id) {
  for (const Claim& claim : claims) {
    if (claim.id == id) return claim;
  }
  throw std::invalid_argument(id);
}

TEST(Claims, EveryOneCanHoldInFullInPartAndNot) {
  for (const Claim& claim : judge_claims(results_of_the_paper())) {
    EXPECT_EQ(claim.verdict, yes) << claim.id << ": " << claim.text("finding");
    EXPECT_EQ(claim.text("part"), "") << claim.id;
  }
  for (const Claim& claim : judge_claims(results_in_part())) {
    const bool has_no_third = claim.id == "no-velocity";
    EXPECT_EQ(claim.verdict, has_no_third ? yes : partly) << claim.id << ": " << claim.text("finding");
    EXPECT_EQ(claim.text("part").empty(), has_no_third) << claim.id;
  }
  for (const Claim& claim : judge_claims(results_against_it())) {
    EXPECT_EQ(claim.verdict, no) << claim.id << ": " << claim.text("finding");
    EXPECT_EQ(claim.text("part"), "") << claim.id;
  }
}

TEST(Verdicts, NeedTheirQuorum) {
  using Cases = std::vector<Case>;
  const Case holds = {"", {}, true}, in_part = {"", {}, false, true}, fails = {"", {}},
             shown = {"", {}, true, true, false};
  EXPECT_EQ(judge(Cases{holds, holds, shown}, Quorum::all), yes);
  EXPECT_EQ(judge(Cases{holds, in_part}, Quorum::all), partly);
  EXPECT_EQ(judge(Cases{holds, fails}, Quorum::all), no);
  EXPECT_EQ(judge(Cases{holds, fails}, Quorum::some), partly);
  EXPECT_EQ(judge(Cases{in_part, fails}, Quorum::some), no);
  EXPECT_EQ(judge(Cases{holds, holds, fails}, Quorum::most), partly);
  EXPECT_EQ(judge(Cases{holds, fails}, Quorum::most), no) << "just half";
  EXPECT_EQ(judge(Cases{holds, holds, fails}, Quorum::half), yes);
  EXPECT_EQ(judge(Cases{holds, fails}, Quorum::half), partly) << "just half";
  for (const Quorum quorum : {Quorum::all, Quorum::some, Quorum::most, Quorum::half}) {
    EXPECT_EQ(judge(Cases{shown}, quorum), no) << "no case proves nothing";
    EXPECT_EQ(judge(Cases{fails, shown}, quorum), no);
  }
}

Verdict verdict_after(const std::string& id, const std::function<void(ClaimResults&)>& change) {
  ClaimResults results = results_of_the_paper();
  change(results);
  return find_claim(judge_claims(results), id).verdict;
}

TEST(Verdicts, ANumberThatIsLostProvesNothing) {
  for (const double lost : {NAN, INFINITY}) {
    EXPECT_EQ(verdict_after("stretch-bound", [=](ClaimResults& r) { r.strong_runs[0].stretch = {0.04, lost}; }), no);
    EXPECT_EQ(verdict_after("stretch-bound", [=](ClaimResults& r) { r.strong_runs[0].stretch = {lost, 0.04}; }), no);
    EXPECT_EQ(verdict_after("free-surface", [=](ClaimResults& r) { r.strong_runs[0].surface = {0.2, lost}; }), partly);
    EXPECT_EQ(verdict_after("free-surface", [=](ClaimResults& r) { r.strong_runs[0].surface = {lost, 0.2}; }), no);
    EXPECT_EQ(verdict_after("any-garment", [=](ClaimResults& r) { r.garments[0].strong.max_stretch_seen = lost; }), no);
    EXPECT_EQ(verdict_after("ideal-overstretches", [=](ClaimResults& r) { r.methods[2].max_stretch = {lost}; }), no);
  }
  EXPECT_EQ(verdict_after("real-time", [](ClaimResults& r) { r.frame_times[0].max_stretch_seen = NAN; }), yes)
      << "one setting of a model is enough";
  EXPECT_EQ(verdict_after("any-garment", [](ClaimResults& r) { r.garments.clear(); }), no);
}

TEST(Verdicts, LieOnTheirBounds) {
  const auto stretched = [](double on_the_way) {
    return [=](ClaimResults& r) { r.strong_runs[0].stretch = {0.05, on_the_way}; };
  };
  EXPECT_EQ(verdict_after("stretch-bound", stretched(0.05)), yes);
  EXPECT_EQ(verdict_after("stretch-bound", stretched(0.051)), partly);
  const auto moved_last = [](double last_m) { return [=](ClaimResults& r) { r.fall->moved_m = {1.0, last_m}; }; };
  EXPECT_EQ(verdict_after("convergence", moved_last(9e-4)), yes);
  EXPECT_EQ(verdict_after("convergence", moved_last(2e-3)), partly);
  EXPECT_EQ(verdict_after("convergence", moved_last(0.2)), no);
  for (const Mapping& bad : {Mapping{3, 1, 10, 9, 3, 0}, {3, 1, 10, 10, 0, 0}, {3, 1, 10, 10, 3, 1}, Mapping{}}) {
    EXPECT_EQ(verdict_after("any-garment", [&](ClaimResults& r) { r.garments[0].mapping = bad; }), no);
  }
  const auto growth_like = [](double power) {
    return [=](ClaimResults& r) {
      for (FrameTimes& time : r.frame_times) time.frame_ms = {1e-3 * std::pow(time.triangles, power)};
    };
  };
  EXPECT_EQ(verdict_after("growth", growth_like(1.21)), partly);
  EXPECT_EQ(verdict_after("growth", growth_like(1.19)), no);
}

// Measured results that were once called "holds with a condition".
TEST(Claims, WhatTheLetterOfThePaperReachesIsNoBound) {
  ClaimResults results = results_of_the_paper();
  results.pinned[0]->max_stretch_seen = 0.067;
  results.strong_runs = {{"shirt", false, 1, 10, {8.48, 10.1}},
                         {"shirt", false, 1, 50, {1.48, 2.1}},
                         {"shirt", false, 1, 200, {0.46, 0.5}}};
  results.frame_times.clear();
  for (const auto& [triangles, few_ms, many_ms] : {std::tuple(1028, 0.4, 4.3), {5280, 2.1, 22.0}, {10600, 4.2, 46.0}}) {
    results.frame_times.push_back({triangles, 1, 10, {few_ms}, triangles > 2000 ? 8.48 : 0.46});
    results.frame_times.push_back({triangles, 100, 1, {many_ms}, 0.047});
  }
  const std::vector<Claim> claims = judge_claims(results);
  for (const char* id : {"stretch-bound", "real-time", "growth"}) {
    EXPECT_EQ(find_claim(claims, id).verdict, no) << id;
  }
}

TEST(Claims, BoundedHasALineOfItsOwnAndDecidesNothing) {
  for (ClaimResults results : {results_of_the_paper(), results_in_part(), results_against_it()}) {
    const std::vector<Claim> before = judge_claims(results);
    for (std::optional<Recording>& run : results.shirts) {
      run->max_stretch_seen = 9.0;
      run->max_surface_stretch = {9.5, 8.5};
    }
    for (FrameTimes& time : results.bounded_times) {
      time.frame_ms = {1e6};
      time.max_stretch_seen = 9.0;
    }
    results.garments[0].bounded = {INFINITY, 1e6};
    const std::vector<Claim> after = judge_claims(results);
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(before[i].verdict, after[i].verdict) << before[i].id;
      EXPECT_EQ(before[i].text("finding"), after[i].text("finding"));
    }
    for (const char* id : {"stretch-bound", "real-time", "any-garment"}) {
      EXPECT_CONTAINS(find_claim(before, id).text("bounded"), " ms");
      EXPECT_NE(find_claim(before, id).text("bounded"), find_claim(after, id).text("bounded")) << id;
    }
    EXPECT_CONTAINS(find_claim(after, "free-surface").text("bounded"),
                    "springs 900 %, the surface 950 %, 99 of 100 triangles 850 %");
  }
}

TEST(Claims, FindingsSayTheNumbersThatDecide) {
  const std::vector<Claim> in_part = judge_claims(results_in_part());
  const std::vector<Claim> against = judge_claims(results_against_it());
  const auto expect_in = [](const std::vector<Claim>& claims, const std::string& id, const std::string& text) {
    const Claim& claim = find_claim(claims, id);
    EXPECT_CONTAINS(claim.text("part") + claim.text("finding"), text);
  };
  expect_in(in_part, "stretch-bound", "2 of 3 runs keep 5 % in every frame");
  expect_in(in_part, "stretch-bound", "on the way 6.70 %");
  expect_in(against, "stretch-bound", "at the end 848 %");
  expect_in(in_part, "free-surface", "the most stretched triangle of every run");
  expect_in(in_part, "free-surface", "In 1 of 3 runs one triangle in a hundred");
  expect_in(in_part, "free-surface", "springs 6.70 %, the surface 16 %, 99 of 100 triangles 6 %");
  expect_in(in_part, "real-time", "for the shirts of 1028 triangles; 5280 triangles");
  expect_in(against, "real-time", "10600 triangles, 1 step x 1 sweep: a frame 10.6 ms, largest stretch 848 %");
  expect_in(against, "growth", "exponent of the power 1,");
  expect_in(in_part, "growth", "not by a geometric law with both settings");
  expect_in(in_part, "any-garment", "1 of 2 within the bound");
  expect_in(against, "any-garment", "1 loose vertex");
  expect_in(in_part, "ideal-overstretches", "with springs of 50 N/m, not with springs of 100 N/m");
  expect_in(in_part, "threshold-vibrates", "with steps of 1/160 s, not with steps of 1/640 s");
}

TEST(Claims, WhatBoundedWasAskedToKeepFollowsFromTheScene) {
  ClaimResults results = results_of_the_paper();
  for (const sim::BoundKind kind : sim::all_bound_kinds) {
    for (std::optional<Recording>& run : results.shirts) {
      run->scene.simulation.solver.bounded = {.bound = kind, .max_stretch = 0.02};
    }
    const Claim claim = find_claim(judge_claims(results), "free-surface");
    EXPECT_CONTAINS(claim.text("bounded"), sim::to_name(kind) + std::string(" within 2 %: springs 0.97"));
    EXPECT_EQ(claim.bounded_numbers.size(), 3 * results.shirts.size());
  }
}

TEST(Claims, WhatWasRefusedHasNoNumbers) {
  ClaimResults results = results_of_the_paper();
  GarmentTrial refused;
  refused.file = "refused.obj";
  refused.refusal = "no reader knows this kind of file";
  results.garments.push_back(refused);
  const Claim claim = find_claim(judge_claims(results), "any-garment");
  EXPECT_CONTAINS(claim.text("finding"), "refused.obj was refused: no reader");
  for (const std::vector<MeasuredNumber>& numbers : {claim.numbers, claim.bounded_numbers}) {
    EXPECT_FALSE(numbers.empty());
    for (const MeasuredNumber& number : numbers) {
      EXPECT_EQ(number.name.find("refused.obj"), std::string::npos) << number.name;
    }
  }
}

TEST(Claims, APowerLawIsFittedExactly) {
  const std::vector<std::array<double, 2>> exact = {
      {1e3, 2e-6 * std::pow(1e3, 1.2)}, {1e4, 2e-6 * std::pow(1e4, 1.2)}, {8e4, 2e-6 * std::pow(8e4, 1.2)}};
  EXPECT_NEAR(fit_power_law(exact).exponent, 1.2, 1e-12);
  EXPECT_NEAR(fit_power_law(exact).factor, 2e-6, 1e-15);
}

TEST(Claims, NumbersAreWrittenAsPeopleDo) {
  const auto text = [](double value, int digits) { return number_text({"", value, "m", digits}); };
  EXPECT_EQ(text(6.0755e-7, 3), "6.08 × 10⁻⁷ m");
  EXPECT_EQ(text(848.13, 2), "848 m");
  EXPECT_EQ(text(26.97, 3), "27.0 m");
  EXPECT_EQ(text(0.0042410, 3), "0.00424 m");
  EXPECT_EQ(text(-19282.0, 6), "-19282 m");
  EXPECT_EQ(text(0.97, 3), "0.970 m");
  EXPECT_EQ(text(3.0, 3), "3 m");
  EXPECT_EQ(number_text({"", INFINITY, "m"}), "diverged");
}

TEST(Report, HasEveryClaimEvenWhereARunDiverged) {
  ClaimResults results = results_of_the_paper();
  EXPECT_EQ(report_html(judge_claims(results), {}, {}, {}).find("diverged"), std::string::npos);
  results.methods[4].diverged_at_s = 0.5;
  const std::vector<Claim> claims = judge_claims(results);
  const std::string html = report_html(claims, {}, {}, {});
  EXPECT_CONTAINS(html, ">diverged</td>");
  EXPECT_EQ(claims.size(), 15U);
  for (const Claim& claim : claims) EXPECT_CONTAINS(html, "id=\"" + claim.id + '"');
}

TEST(Report, IsOneFileWithPicturesInside) {
  renderer::Image picture = renderer::make_image(40, 20);
  const std::vector<DrawnFigure> figures = {{"fig1", "A & B", picture}, {"fig7", "C", picture}};
  const std::string html = report_html(judge_claims(results_in_part()), {}, figures, {});
  const std::size_t place = html.find("<figure id=\"fig7\">");
  EXPECT_GT(place, html.find("id=\"threshold-vibrates\"")) << "after the first claim that shows it";
  EXPECT_LT(place, html.find("id=\"ideal-overstretches\""));
  EXPECT_NE(html.find("src=\"data:image/png;base64,iVBOR"), std::string::npos);
  EXPECT_NE(html.find("A &amp; B"), std::string::npos);
  EXPECT_EQ(html.find("http"), std::string::npos) << "nothing from elsewhere";
}

TEST(Report, SaysBelowFigure8WhatWasMeasuredOfEachMethod) {
  ClaimResults results = results_of_the_paper();
  MethodTrial& longest = trial_in(results, MethodTest::steps, ideal, trial_shirt_triangles, trial_step_factors.back());
  longest.is_lost = true;
  const std::string html = report_html({}, {}, {}, {}, methods_html(results));
  EXPECT_CONTAINS(html,
                  "<tr><td>ideal</td><td class=\"number\">20</td><td class=\"number\">10</td>"
                  "<td class=\"number\">10 to 10</td><td class=\"number\">10 %</td>"
                  "<td class=\"number\">20 %</td><td class=\"number\">1.0</td>"
                  "<td class=\"number\">lost</td><td class=\"number\">1.0</td></tr>");
  for (const sim::SolverKind kind : trial_methods) {
    EXPECT_CONTAINS(html, std::string("<tr><td>") + to_name(kind) + "</td>");
  }
  EXPECT_EQ(html.find("<!--"), std::string::npos);
}

TEST(Report, LinksToTheFilesBesideIt) {
  const std::vector<DrawnFigure> figures = {{"fig1", "A", renderer::make_image(4, 2)}};
  const std::string html = report_html({}, {}, figures, {});
  EXPECT_CONTAINS(html, "<a href=\"fig1.pdf\">");
  EXPECT_CONTAINS(html, "<a href=\"fig1.png\">");
  EXPECT_EQ(html.find("fig1.csv"), std::string::npos);
  EXPECT_CONTAINS(report_html({}, {}, std::array{DrawnFigure{"fig3", "B", renderer::make_image(4, 2), true}}, {}),
                  "<a href=\"fig3.csv\">");
}

TEST(Report, CallsWhatCannotFailACheck) {
  EXPECT_CONTAINS(report_html(judge_claims(results_of_the_paper()), {}, {}, {}), "<b>check: passed</b>");
  EXPECT_CONTAINS(report_html(judge_claims(results_against_it()), {}, {}, {}), "<b>check: failed</b>");
}

TEST(Claims, SpeedIsJudgedWhereClothIsStretchedAlike) {
  ClaimResults results = results_of_the_paper();
  for (MethodTrial& timed : results.trials_of(MethodTest::time)) {
    for (TrialFrame& frame : timed.frames) {
      frame.frame_ms = timed.kind == strong ? 5.0 : 10.0;
      frame.stretch = timed.kind == strong ? 0.14 : 0.06;
    }
  }
  EXPECT_EQ(find_claim(judge_claims(results), "execution-speed").verdict, no);
}

TEST(Report, ShowsEachVerdictAndWhatBoundedReaches) {
  const auto html_of = [](const ClaimResults& results) { return report_html(judge_claims(results), {}, {}, {}); };
  const std::string pages[] = {html_of(results_of_the_paper()), html_of(results_in_part()),
                               html_of(results_against_it())};
  const Verdict verdicts[] = {yes, partly, no};
  for (std::size_t page = 0; page < 3; ++page) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string badge = std::string("<span class=\"verdict\">") + to_name(verdicts[i]) + "<";
      // Even in the report of "holds in part" one claim holds, because it has no third verdict.
      EXPECT_EQ(pages[page].find(badge) != std::string::npos, i == page) << badge;
    }
    EXPECT_NE(pages[page].find("With the solver bounded instead"), std::string::npos);
  }
}

/// Returns the results of a bounded scene with contact that keeps both promises, and of one without contact.
ClaimResults results_with_promises() {
  ClaimResults results;
  for (const std::size_t i : {1U, 2U}) {
    Recording& shirt = results.shirts[i].emplace();
    shirt.scene.name = i == 1 ? "apart" : "without contact";
    shirt.scene.simulation.solver.kind = sim::SolverKind::bounded;
    shirt.scene.simulation.solver.bounded = {.max_stretch = 0.01, .contact = i == 1};
    shirt.promises = {241, {0.0099, 0.3}, i == 1 ? 0U : 70U, i == 1 ? 0U : 40U, i == 1 ? 0 : 2};
  }
  Recording& strong = results.pinned[0].emplace();
  strong.scene.name = "strong";
  strong.scene.simulation.solver.kind = sim::SolverKind::strong;
  strong.promises = {101, {0.19, 0.4}, 0, 0, 0};
  results.pinned[1].emplace();
  return results;
}

TEST(Report, SaysOfEveryCheckedSceneWhatIsPromisedAndKept) {
  ClaimResults results = results_with_promises();
  const std::vector<PromiseResult> promises = promise_results(results);
  ASSERT_EQ(promises.size(), 3U) << "nobody has checked the other one";
  EXPECT_EQ(describe(promises),
            "583 frames of 3 scenes were checked. A bound on stretch is promised in 2 of the scenes and kept in "
            "every frame of 2; that nothing crosses is promised in 1 and kept in every frame of 1. Where contact "
            "is off nothing is promised about it, and triangles do cross: 70 pairs in all frames together.");
  const std::string html = report_html({}, promises, {}, {});
  EXPECT_CONTAINS(html,
                  "apart</a></td><td class=\"number\">241</td><td class=\"number\">0.990 %</td>"
                  "<td class=\"number\">1 %</td><td><b>kept</b></td><td class=\"number\">0</td>"
                  "<td><b>kept</b></td></tr>");
  EXPECT_CONTAINS(html, "70 in 2 of the frames, 40 at most</td><td>not promised</td></tr>");
  EXPECT_CONTAINS(html, "<tr class=\"part\"><td><a href=\"#fig4\">strong</a>");
  EXPECT_EQ(html.find("broken"), std::string::npos);

  results.shirts[1]->promises->crossing_frames = 1;
  results.shirts[1]->promises->stretch.springs = 0.0101;
  const std::string broken = report_html({}, promise_results(results), {}, {});
  EXPECT_CONTAINS(broken, "<tr class=\"fails\"><td><a href=\"#fig5\">apart</a>");
  EXPECT_CONTAINS(broken, ">1.01 %</td><td class=\"number\">1 %</td><td><b>broken</b>");
}

TEST(Report, Base64PadsIncompleteGroups) {
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
