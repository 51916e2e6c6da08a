#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace taut::app {

/// What numbers say about a claim of the paper.
enum class Verdict { holds, holds_with_condition, does_not_hold };

/// "holds", "holds with a condition", "does not hold".
const char* name_of(Verdict verdict);

// The thresholds of the verdicts. Each function below is pure: numbers in, verdict out.

/// The paper's bound on over-stretch.
inline constexpr double stretch_bound = 0.05;
/// A frame at 60 Hz.
inline constexpr double real_time_ms = 1000.0 / 60.0;
/// Cloth that moves faster than this (root mean square) when it should long be at rest vibrates: a
/// millimetre in a tenth of a second can be seen.
inline constexpr double vibration_m_per_s = 0.01;
/// Exponents of growth up to this are called "in proportion": timing leaves about so much in doubt.
inline constexpr double proportional_exponent = 1.2;

/// The largest stretch of a run's last frame and of all its frames.
struct StretchNumbers {
  double at_end = 0.0;
  double on_the_way = 0.0;
};

/// `kept` are the runs with settings that are to keep the bound: the cloth of figure 4 and the shirt with
/// short steps. Holds where they do in every frame and runs with few sweeps do as well; with a condition
/// where they do at the end and never go beyond twice the bound, whatever becomes of those with few sweeps.
Verdict judge_stretch_bound(std::span<const StretchNumbers> kept, std::span<const double> few_sweeps);

/// Holds where the cloth came to rest or moves by less than a thousandth of its peak; with a condition below
/// a tenth.
Verdict judge_convergence(double peak_m, double last_m, bool came_to_rest);

/// Holds where two runs end in the same bits, one of which went on from positions alone.
Verdict judge_no_velocity(std::uint64_t uninterrupted_hash, std::uint64_t restarted_hash);

/// Median times of a frame, in ms. Holds where all are within a 60th of a second; with a condition where
/// those with few sweeps all are, or those with short steps all are.
Verdict judge_real_time(std::span<const double> few_sweeps_ms, std::span<const double> short_steps_ms);

/// "Geometrically" over the number of triangles would be faster than in proportion. Holds above the
/// proportional exponent. In proportion, refining by halving the edges multiplies triangles and time by
/// four, which is a geometric sequence in the levels of refinement: with that condition it holds from 0.8 on.
Verdict judge_growth(double exponent);

/// Of each model: springs that are not edges or edges that are none of the springs, vertices no spring holds,
/// flexural springs. Holds where only the last differs from zero in all.
struct MappingNumbers {
  std::size_t edges = 0;
  std::size_t structural = 0;
  std::size_t flexural = 0;
  std::size_t loose_vertices = 0;
};
Verdict judge_mapping(std::span<const MappingNumbers> models);

/// Unrest of the threshold method and of the strong constraint with the short and with the long step; not
/// finite for a run that diverged, which counts as vibrating. Holds where the threshold vibrates with both
/// steps and the strong constraint with none; with a condition where it is so with one of the steps.
struct UnrestNumbers {
  double short_step_m_per_s = 0.0;
  double long_step_m_per_s = 0.0;
};
Verdict judge_threshold_vibrates(const UnrestNumbers& threshold, const UnrestNumbers& strong);

/// Ideal springs and the strong constraint on the same cloth. With a condition where the first exceed the
/// bound and the second does not: how far they stretch is a matter of the stiffness that was chosen.
Verdict judge_ideal_overstretches(double ideal_stretch, double strong_stretch);

}  // namespace taut::app
