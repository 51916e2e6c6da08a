#include "app/report/claims.hpp"

#include <fmt/core.h>

#include "app/figures/moments.hpp"

namespace taut::app {
namespace {

struct Rule {
  ClaimText text;
  Judgement (*judge)(const Results&);
};

std::vector<Rule> rules_of_motion() {
  return {
      {{"stretch-bound", "III", "The strong constraint keeps over-stretch within 5 %.",
        "A 9x9 cloth held by two corners (one step of 1/64 s a frame, 8 sweeps); the shirt of 10600 "
        "triangles with "
        "one step a frame and 10, 50 and 200 sweeps after 0.75 s; and the same shirt with the solver that "
        "chooses its "
        "steps and certifies a bound of 1 %, after 4 s under gravity and in a wind. Measured: the largest "
        "stretch of "
        "any structural spring.",
        "at most 5 % in every frame of all of them; with a condition where the 9x9 cloth and the certified "
        "shirt at "
        "the end, and never above 10 %",
        "Sweeps hand a correction on by one spring each, so that fine meshes need very many of them or short "
        "time "
        "steps. Sudden starts go beyond the bound for a moment.",
        "fig4"},
       judge_bound},
      {{"convergence", "II", "The iteration converges: a mass point's coordinate becomes stable.",
        "How far the middle of the free edge of the falling 33x33 cloth moves in each step.",
        fmt::format(
            "the cloth slows down to {} m/s (root mean square) for half a second, or the point moves by less "
            "than a thousandth of its peak",
            fall_rest_m_per_s),
        "Not monotonically: the cloth swings, in air that slows it down.", "fig3"},
       judge_fall},
      {{"no-velocity", "II",
        "Previous, current and predicted positions are all there is to a mass point; no velocity is kept.",
        "A run is copied in the middle as nothing but its current and previous positions and the length of a "
        "step; "
        "copy and original go on and are compared bit by bit.",
        "equal hashes of all positions",
        "The velocity is implied: it is the difference of two positions over the time step.", ""},
       judge_velocity},
      {{"real-time", "IV", "Garments of these sizes are simulated in real time.",
        "Medians of frames of 1/60 s of each shirt under gravity, with 1 step of 10 sweeps a frame (1 x 10) "
        "and 100 "
        "steps of 1 sweep (100 x 1); simulation alone, on one thread while nothing else of this program ran.",
        "at most 16.7 ms a frame for all models: with both settings, or with one as the condition",
        "The setting that keeps the bound on fine models costs many times as much as the one that does not.",
        "fig6"},
       judge_speed},
      {{"growth", "IV", "Computation grows geometrically as the model is refined.",
        "A power of the number of triangles is fitted to the shortest times of a frame of the three shirts, "
        "for each "
        "of two settings: 1 step of 10 sweeps a frame, 100 steps of 1 sweep. The smaller exponent is judged: "
        "other programs can bend either.",
        fmt::format("above {:.1f}: faster than in proportion to the triangles; 0.8 to {:.1f}: in proportion, "
                    "which is "
                    "geometric in the levels of refinement alone",
                    proportional_exponent, proportional_exponent),
        "A finer model needs more steps as well if its stretch is to stay the same.", "fig6"},
       judge_cost},
  };
}

std::vector<Rule> rules_of_springs() {
  return {
      {{"any-garment", "I, V", "Any garment made of triangles maps to springs, regular or not.",
        "Three shirts of irregular triangles are mapped: structural springs have to be exactly the edges, "
        "every "
        "vertex has to be held by one, and there have to be flexural springs.",
        "no edge without a spring, no loose vertex, some flexural springs, in all three",
        "Triangles have no diagonals, so a triangle model has no shear springs; its edges do their work.",
        "fig1"},
       judge_any_garment},
      {{"threshold-vibrates", "I, III",
        "Pulling springs back to a threshold makes them vibrate; the strong constraint does not.",
        fmt::format(
            "The 9x9 cloth with springs of 50 N/m and a threshold of 5 %, against 8 sweeps of the strong "
            "constraint, with steps of 1/{:.0f} s and 1/{:.0f} s: root mean square speed over the last "
            "quarter of {:.0f} s.",
            method_rates_hz[0], method_rates_hz[1], methods_duration_s),
        fmt::format(
            "vibrates above {} m/s, or where it diverges; with both steps, or with one as the condition",
            vibration_m_per_s),
        "With steps short enough for the springs themselves to be stable (about 1/255 s here) the threshold "
        "method "
        "settles like the others. With longer ones the springs blow up, the threshold only bounds the "
        "damage, and "
        "the cloth shakes for good. The strong constraint has no such limit.",
        "fig7"},
       judge_threshold},
      {{"ideal-overstretches", "III",
        "An ideal mass-spring model over-stretches where the strong constraint does not.",
        fmt::format("The same cloth with ideal springs of 50 N/m and with the strong constraint, steps of "
                    "1/{:.0f} s: "
                    "the largest stretch over the last quarter of {:.0f} s.",
                    method_rates_hz[0], methods_duration_s),
        "ideal above 5 %, strong at most 5 %; never more than with a condition, as the stiffness was chosen",
        "Stiffer springs stretch less, at the price of shorter steps.", "fig7"},
       judge_ideal},
  };
}

}  // namespace

std::vector<Claim> judge_claims(const Results& results) {
  std::vector<Claim> claims;
  for (const std::vector<Rule>& rules : {rules_of_motion(), rules_of_springs()}) {
    for (const Rule& rule : rules) {
      claims.push_back({rule.text, rule.judge(results)});
    }
  }
  return claims;
}

}  // namespace taut::app
