#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "app/figures/experiments/experiments.hpp"

namespace taut::app {

/// Whether measurements support a claim of the paper. The best comes first.
enum class Verdict { holds, holds_in_part, does_not_hold };

/// "holds", "holds in part" or "does not hold".
const char* name_of(Verdict verdict);

// The rules. Each is about the paper's method and pure: numbers in, verdict out. A number that is not finite,
// or that is not there, never helps a claim.

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

/// Holds if all runs keep the bound in every frame; in part if all keep it in their last frame. An empty list
/// does not hold, also below.
Verdict judge_stretch_bound(std::span<const StretchNumbers> runs);

/// How much springs and triangles of one run are stretched at most, in any frame.
struct SurfaceNumbers {
  double springs = 0.0;  ///< of the most stretched spring, a fraction
  sim::SurfaceStretch surface;
};
/// Whether a stretch of the surface exceeds that of the springs by more than `surface_excess`.
bool exceeds_springs(double surface, double springs);
/// Holds if in all runs one triangle in a hundred is stretched by more than every spring; in part if in all
/// runs the most stretched triangle is. Both as `exceeds_springs` has it.
Verdict judge_free_surface(std::span<const SurfaceNumbers> runs);

/// Holds if the cloth came to rest, or if its last movement is less than 0.001 of its largest one; in part if
/// it is less than 0.1. Both are in metres per step.
Verdict judge_convergence(double peak_m, double last_m, bool came_to_rest);

/// Holds if the two runs ended with the same bits; one of them was continued from positions alone. It never
/// holds in part.
Verdict judge_no_velocity(std::uint64_t uninterrupted_hash, std::uint64_t restarted_hash);

/// The cost and the stretch of one setting of the solver for a model.
struct PacedModel {
  int triangles = 0;
  double frame_ms = 0.0;  ///< time per frame
  double stretch = 0.0;   ///< largest stretch, a fraction
};
/// Whether a frame takes at most real_time_ms and the bound is kept.
bool is_in_real_time(const PacedModel& model);
/// A model is in real time if one of its settings is. Holds if all models are; in part if more than half are.
Verdict judge_real_time(std::span<const PacedModel> models);

/// Does not hold if the exponent is at most proportional_exponent. Above it, holds if a geometric law fits
/// better than a power law, and else in part.
Verdict judge_growth(const TimeGrowth& growth);

/// Whether every edge is a structural spring, every vertex has a spring, and there are flexural springs.
bool is_mapped(const Mapping& mapping);
/// Holds if every garment is mapped and keeps the bound in every frame; in part if every garment is mapped
/// and simulated to the end.
Verdict judge_any_garment(std::span<const GarmentTrial> trials);

/// Root mean square speed of cloth at rest, with both time steps. Not finite if the run diverged, which
/// counts as vibrating.
struct UnrestNumbers {
  double short_step_m_per_s = 0.0;
  double long_step_m_per_s = 0.0;
};
/// Holds if the threshold method vibrates with both steps and the strong constraint with neither; in part if
/// that is so with one of the steps.
Verdict judge_threshold_vibrates(const UnrestNumbers& threshold, const UnrestNumbers& strong);

/// Compares ideal springs of several stiffnesses with the strong constraint, by their largest stretch
/// (infinite: diverged). Holds if the strong constraint keeps the bound and all ideal springs exceed it; in
/// part if only some ideal springs exceed it.
Verdict judge_ideal_overstretches(std::span<const double> ideal_stretches, double strong_stretch);

// Of the methods in figure 8.

/// How many times as long as a method another takes, per mesh. Holds if it is at least `least` for all
/// meshes; in part if for some.
Verdict judge_faster(std::span<const double> times_as_long, double least);

/// Root mean square speed in m/s of cloth that should be at rest, with a threshold and with the same springs
/// without. Holds if it vibrates with the threshold alone; in part if it moves more than twice as fast with
/// it.
Verdict judge_threshold_unrest(double with_threshold_m_per_s, double without_m_per_s);

/// The largest stretch as multiple of the threshold, of each method that has one the least of all meshes.
/// Holds if all exceed it by more than `threshold_excess`; in part if some do.
Verdict judge_neighbours_stretch(std::span<const double> multiples);

/// The largest stretch of each method. Holds if more than half exceed the paper's bound; in part if any does.
Verdict judge_stretch_ignored(std::span<const double> stretches);

/// The largest stretch with each length of a time step (infinite: diverged). Holds if all keep the paper's
/// bound; in part if none diverged.
Verdict judge_robust(std::span<const double> stretches);

}  // namespace taut::app
