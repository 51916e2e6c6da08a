#include "app/report/claims.hpp"

#include <fmt/core.h>

#include "app/figures/experiments/moments.hpp"

namespace taut::app {
namespace {

struct Rule {
  ClaimText text;
  Judgement (*judge)(const Results&);
};

Rule rule_of_bound() {
  return {
      {"stretch-bound", "III", "The strong constraint keeps over-stretch within 5 %.",
       "The 9x9 cloth of figure 4, and once more with springs that are rigid both ways, as equation (3) has "
       "them; the shirt of 10600 triangles for 0.75 s with one step a frame of 10, 50 and 200 sweeps and "
       "with 100 steps of 1 sweep, each with springs that give way to compression, as cloth that falls "
       "into folds needs, and with rigid ones. Measured: the largest stretch of any structural spring.",
       "holds where every run keeps 5 % in every frame; in part where every run does in its last frame; "
       "else it does not hold",
       "The paper renders after every step, which is one step a frame, and says nothing of the number of "
       "sweeps. A sweep hands a correction on by about one spring.",
       "fig4"},
      judge_bound};
}

Rule rule_of_convergence() {
  return {
      {"convergence", "II", "The iteration converges: a mass point's coordinate becomes stable.",
       "How far the middle of the free edge of the falling 33x33 cloth moves in each step.",
       fmt::format("holds where the cloth stays within {:g} mm (root mean square) for {:g} s, or "
                   "the point moves by less than a thousandth of its peak; in part below a tenth; else it "
                   "does not hold",
                   1e3 * fall_rest_m, fall_rest_s),
       "The cloth hangs in air, which slows its swing down.", "fig3"},
      judge_fall};
}

Rule rule_of_velocity() {
  return {
      {"no-velocity", "II",
       "Previous, current and predicted positions are all there is to a mass point; no velocity is kept.",
       "A run is copied in the middle as nothing but its current and previous positions and the length of a "
       "step; copy and original go on and are compared bit by bit.",
       "holds where the hashes of all positions are equal; else it does not hold. Bits are equal or not: it "
       "cannot hold in part",
       "The velocity is implied: it is the difference of two positions over the time step.", ""},
      judge_velocity};
}

Rule rule_of_speed() {
  return {
      {"real-time", "IV", "Garments of these sizes are simulated in real time.",
       "Frames of 1/60 s of each shirt let go under gravity, with 1 step of 10 sweeps a frame and with 100 "
       "steps of 1 sweep: the median time, and the largest stretch of those very frames. Simulation "
       "alone, on one thread while nothing else of this program ran.",
       fmt::format("a model is in real time where one of the settings takes at most {:.1f} ms a frame and "
                   "keeps 5 %; holds where all models are, in part where more than half are; else it does "
                   "not hold",
                   real_time_ms),
       "Time alone says nothing: if cloth may stretch, a frame can be had at any price.", "fig6"},
      judge_speed};
}

Rule rule_of_growth() {
  return {
      {"growth", "IV", "Computation grows geometrically as the model is refined.",
       "Two laws are fitted to the logarithms of the shortest times of a frame of the three shirts, for 1 "
       "step of 10 sweeps a frame and for 100 steps of 1 sweep: a power of the number of triangles, and "
       "a geometric law, by which every further triangle multiplies the time by the same factor.",
       fmt::format("with an exponent up to {:.1f} time grows in proportion, and the claim does not hold; "
                   "above, it holds where the geometric law fits better, and in part where the power does. "
                   "The worse of both settings counts: other programs can bend either",
                   proportional_exponent),
       "Any power is geometric in the levels of a refinement that halves the edges, a proportional one "
       "too. Steps and sweeps are the same for all models here; equal stretch would ask for more of them "
       "on finer models.",
       "fig6"},
      judge_cost};
}

Rule rule_of_garments() {
  return {
      {"any-garment", "I, V", "Any garment made of triangles maps to springs, regular or not.",
       fmt::format("Models that differ in what their faces are and how they hang together are written in "
                   "several formats, read as any file is, mapped, hung by their tops and let go for {} "
                   "frames, with {} steps of {} sweeps a frame and rigid springs; and so are the three "
                   "shirts, whose triangles are irregular.",
                   trial_frames, trial_steps, trial_sweeps),
       "a garment is mapped where every edge is a structural spring, every vertex is held by a spring and "
       "there are flexural springs; holds where all are mapped and keep 5 % in every frame; in part where "
       "all are mapped and simulated to the end; else it does not hold",
       "Triangles have no diagonals, so a triangle model has no shear springs; its edges do their work.",
       "fig1"},
      judge_garments};
}

Rule rule_of_threshold() {
  return {
      {"threshold-vibrates", "I, III",
       "Pulling springs back to a threshold makes them vibrate; the strong constraint does not.",
       fmt::format(
           "The 9x9 cloth with springs of 50 N/m and a threshold of 5 %, against 8 sweeps of the strong "
           "constraint, with steps of 1/{:.0f} s and 1/{:.0f} s: root mean square speed over the last "
           "quarter of {:.0f} s.",
           method_rates_hz[0], method_rates_hz[1], methods_duration_s),
       fmt::format("cloth vibrates above {} m/s, or where it diverges; holds where the threshold does with "
                   "both steps and the strong constraint with none, in part where it is so with one of "
                   "the steps; else it does not hold",
                   vibration_m_per_s),
       "By themselves these springs are stable with steps up to about 1/255 s: one of the steps is "
       "shorter, one longer.",
       "fig7"},
      judge_threshold};
}

Rule rule_of_ideal() {
  return {{"ideal-overstretches", "III",
           "An ideal mass-spring model over-stretches where the strong constraint does not.",
           fmt::format("The same cloth with ideal springs of several stiffnesses and with the strong "
                       "constraint, steps of 1/{:.0f} s: the largest stretch over the last quarter of {:.0f} "
                       "s.",
                       method_rates_hz[0], methods_duration_s),
           "holds where the strong constraint keeps 5 % and ideal springs of every stiffness exceed it; in "
           "part where those of some do; else it does not hold",
           "Stiffer springs stretch less, at the price of shorter steps: the stiffest are near the most that "
           "this step allows.",
           "fig7"},
          judge_ideal};
}

}  // namespace

std::vector<Claim> judge_claims(const Results& results) {
  std::vector<Claim> claims;
  for (const Rule& rule : {rule_of_bound(), rule_of_convergence(), rule_of_velocity(), rule_of_speed(),
                           rule_of_growth(), rule_of_garments(), rule_of_threshold(), rule_of_ideal()}) {
    claims.push_back({rule.text, rule.judge(results)});
  }
  return claims;
}

}  // namespace taut::app
