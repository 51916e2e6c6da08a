#pragma once

#include "tests/study/claims/trials.hpp"

namespace taut::app {

/// A measured value with its name and unit.
struct MeasuredNumber {
  std::string name;
  double value = 0.0;  ///< not finite if the run diverged
  std::string unit;
  int digits = 3;  ///< significant digits in texts
};

/// Returns the number as text: "3.84 %", "6.08 × 10⁻⁷ m", "diverged".
std::string number_text(const MeasuredNumber& number);

/// Verdict on a claim of the paper by measurements. The best comes first.
enum class Verdict { holds, holds_in_part, does_not_hold };

/// Returns "holds", "holds in part" or "does not hold".
const char* to_name(Verdict verdict);

/// A case of a claim's test: a run, a mesh or a method.
struct Case {
  std::string name;
  std::vector<MeasuredNumber> numbers;  ///< cases are ranked by the first number
  bool holds = false;                   ///< the claim holds for this case
  bool holds_in_part = false;
  bool is_judged = true;  ///< false: only shown, not judged
};

/// Fraction of the judged cases for which a claim must hold.
enum class Quorum {
  all,   ///< holds if all do; in part if all do at least in part
  some,  ///< holds if all do; in part if any does
  most,  ///< holds if all do; in part if more than half do
  half,  ///< holds if more than half do; in part if any does
};

/// Returns the verdict on a claim. Without a judged case it does not hold.
Verdict judge(std::span<const Case> cases, Quorum quorum);

/// The paper's bound on stretch, a fraction.
inline constexpr double paper_stretch_bound = 0.05;
/// Duration of a frame at 60 Hz.
inline constexpr double real_time_ms = 1000.0 / 60.0;
/// Root mean square speed above which cloth at rest vibrates. A movement of 1 mm in 0.1 s is visible.
inline constexpr double vibration_m_per_s = 0.01;
/// Fraction of the springs' stretch by which a surface must stretch more to count as stretching more. No triangle
/// stretches less than any of its edges, so a mere difference would decide nothing.
inline constexpr double surface_excess = 0.1;
/// Ratio of times above which a method is significantly faster than another.
inline constexpr double significantly_faster = 2.0;
/// Fraction of a threshold by which stretch must be larger to exceed it.
inline constexpr double threshold_excess = 0.05;
/// Exponent up to which growth counts as proportional. Measured times are uncertain by about as much.
inline constexpr double proportional_exponent = 1.2;

/// A claim of the paper with the result of its test.
struct Claim {
  std::string id;
  std::map<std::string, std::string> texts;  ///< texts of claims.toml by their keys, with numbers filled in
  bool is_check = false;                     ///< only a mistake of this program can make it fail
  Verdict verdict = Verdict::does_not_hold;
  std::vector<MeasuredNumber> numbers;  ///< numbers that decide
  /// Numbers of the solver `bounded` in the same test. They do not decide, because it is not the paper's method. Empty
  /// if `bounded` was not tested.
  std::vector<MeasuredNumber> bounded_numbers;

  /// Returns a text, or an empty one if the claim has none with this key: "section"; "claim", in our own words; "test";
  /// "rule", by which it is judged; "finding"; "bounded", the finding about `bounded`; "part", which part holds if not
  /// all does; "remark"; "figure", the name of one that shows it.
  std::string text(const std::string& key) const { return texts.contains(key) ? texts.at(key) : ""; }
};

/// Judges all claims by the measurements. A number that is missing or not finite never supports a claim.
std::vector<Claim> judge_claims(const ClaimResults& results);

}  // namespace taut::app
