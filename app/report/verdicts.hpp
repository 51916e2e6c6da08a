#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "app/figures/experiments/experiments.hpp"

namespace taut::app {

/// What numbers say about a claim of the paper; the best first.
enum class Verdict { holds, holds_in_part, does_not_hold };

/// "holds", "holds in part", "does not hold".
const char* name_of(Verdict verdict);

// The rules. Each is about the paper's method and pure: numbers in, verdict out. A number that is not finite,
// or that is not there, never helps a claim.

/// The paper's bound on over-stretch.
inline constexpr double stretch_bound = 0.05;
/// A frame at 60 Hz.
inline constexpr double real_time_ms = 1000.0 / 60.0;
/// Cloth that moves faster than this (root mean square) when it should long be at rest vibrates: a
/// millimetre in a tenth of a second can be seen.
inline constexpr double vibration_m_per_s = 0.01;
/// Exponents of growth up to this are called "in proportion": timing leaves about so much in doubt.
inline constexpr double proportional_exponent = 1.2;

/// Holds where all runs keep the bound in every frame; in part where all do in their last.
Verdict judge_stretch_bound(std::span<const StretchNumbers> runs);

/// Holds where the cloth came to rest or moves by less than a thousandth of its peak; in part below a tenth.
Verdict judge_convergence(double peak_m, double last_m, bool came_to_rest);

/// Holds where two runs end in the same bits, one of which went on from positions alone. Bits are the same or
/// they are not: nothing holds in part.
Verdict judge_no_velocity(std::uint64_t uninterrupted_hash, std::uint64_t restarted_hash);

/// What a setting costs and keeps for the model with so many triangles.
struct PacedModel {
  int triangles = 0;
  double frame_ms = 0.0;
  double stretch = 0.0;
};
bool is_in_real_time(const PacedModel& model);
/// A model is simulated in real time where one of its settings needs no more than a 60th of a second and
/// keeps the bound. Holds where all models are; in part where more than half are.
Verdict judge_real_time(std::span<const PacedModel> models);

/// Does not hold up to the proportional exponent. Above, time grows faster than the number of triangles:
/// holds where a geometric law fits better than a power of the triangles, in part where the power fits
/// better.
Verdict judge_growth(const TimeGrowth& growth);

/// Every edge a structural spring, every vertex held by a spring, and some flexural springs.
bool is_mapped(const Mapping& mapping);
/// Holds where every garment is mapped and keeps the bound in every frame; in part where every one is mapped
/// and simulated to the end.
Verdict judge_any_garment(std::span<const GarmentTrial> trials);

/// Unrest with the short and with the long step; not finite for a run that diverged, which counts as
/// vibrating. Holds where the threshold vibrates with both steps and the strong constraint with none; in part
/// where it is so with one of the steps.
struct UnrestNumbers {
  double short_step_m_per_s = 0.0;
  double long_step_m_per_s = 0.0;
};
Verdict judge_threshold_vibrates(const UnrestNumbers& threshold, const UnrestNumbers& strong);

/// Ideal springs of several stiffnesses (infinite: diverged) and the strong constraint on the same cloth.
/// Holds where the strong constraint keeps the bound and ideal springs of every stiffness exceed it; in part
/// where those of some do.
Verdict judge_ideal_overstretches(std::span<const double> ideal_stretches, double strong_stretch);

}  // namespace taut::app
