#pragma once

#include "tests/claims/trials.hpp"

namespace taut::app {

/// A measured value with its name and unit.
struct MeasuredNumber {
  std::string name;
  double value = 0.0;  ///< not finite if the run diverged
  std::string unit;
  int digits = 3;  ///< significant digits in texts
};

/// The number for people: "3.84 %", "6.08 × 10⁻⁷ m", "diverged".
std::string number_text(const MeasuredNumber& number);

/// Whether measurements support a claim of the paper. The best comes first.
enum class Verdict { holds, holds_in_part, does_not_hold };

/// "holds", "holds in part" or "does not hold".
const char* name_of(Verdict verdict);

/// One case of a claim's test: a run, a mesh or a method.
struct Case {
  std::string name;
  std::vector<MeasuredNumber> numbers;  ///< the first is the one by which cases are ranked
  bool holds = false;                   ///< the claim holds of it
  bool holds_in_part = false;
  bool is_judged = true;  ///< false: its numbers are shown, and decide nothing
};

/// How many of the judged cases a claim needs.
enum class Quorum {
  all,   ///< holds where all do; in part where all do in full or in part
  some,  ///< holds where all do; in part where any does
  most,  ///< holds where all do; in part where more than half do
  half,  ///< holds where more than half do; in part where any does
};

/// The verdict on a claim. Without a judged case it does not hold.
Verdict verdict_of(std::span<const Case> cases, Quorum quorum);

/// The paper's bound on stretch, a fraction.
inline constexpr double paper_stretch_bound = 0.05;
/// Duration of a frame at 60 Hz.
inline constexpr double real_time_ms = 1000.0 / 60.0;
/// Cloth at rest vibrates if its root mean square speed is larger than this. A movement of 1 mm in 0.1 s is
/// visible.
inline constexpr double vibration_m_per_s = 0.01;
/// A surface stretches by more than springs if its stretch exceeds theirs by more than this fraction of
/// theirs. No triangle is stretched by less than any of its edges, so that a mere difference would decide
/// nothing.
inline constexpr double surface_excess = 0.1;
/// A method is significantly faster than another if it takes at most one part in so many of its time.
inline constexpr double significantly_faster = 2.0;
/// A threshold is exceeded by stretch that is larger by more than this fraction of it.
inline constexpr double threshold_excess = 0.05;
/// Up to this exponent, growth counts as proportional. Measured times are uncertain by about that much.
inline constexpr double proportional_exponent = 1.2;

/// A sentence with the numbers it states.
struct Finding {
  std::string text;
  std::vector<MeasuredNumber> measured;
};

/// The result of testing a claim.
struct Judgement {
  Verdict verdict = Verdict::does_not_hold;
  std::string part;  ///< what holds, if the verdict is holds_in_part; otherwise empty
  Finding finding;   ///< the numbers that decide
  /// The result of the solver `bounded` in the same test. It does not decide, because it is not the paper's
  /// method. Its text is empty if `bounded` was not tested.
  Finding bounded;
};

/// A claim of the paper, how it is tested and by which rule it is judged. These texts do not depend on the
/// result.
struct ClaimText {
  std::string id;
  std::string section;  ///< section of the paper
  std::string claim;    ///< in our own words
  std::string test;
  std::string rule;       ///< when the claim holds, holds in part or does not hold
  std::string remark;     ///< what else to know; may be empty
  std::string figure;     ///< name of the figure that shows it; may be empty
  bool is_check = false;  ///< it cannot fail but by a mistake of this program
};

/// A claim with the result of its test.
struct Claim {
  ClaimText text;
  Judgement judgement;
};

/// Judges all claims by what was measured. A number that is not finite, or that is not there, never helps a
/// claim.
std::vector<Claim> judge_claims(const ClaimResults& results);

}  // namespace taut::app
