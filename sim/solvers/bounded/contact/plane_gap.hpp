#pragma once

#include "prelude.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {

// Distances that contact planes keep, and the errors that they must exceed.

/// Fraction of the thickness that the planes of a pair leave between its primitives.
inline constexpr float min_gap_fraction = 0.1F;
/// Largest distance of kinematic primitives from their chords while regions last, as a fraction of the thickness: two
/// of them use less than half of the gap.
inline constexpr float max_off_chord_fraction = 0.02F;
/// Tolerance of half-spaces: vertices further outside, in m, violate them.
inline constexpr float tolerance_m = 2e-8F;
/// Largest distance at which primitives collide, in thicknesses. Planes alone act on more distant ones.
inline const float collision_distance_per_thickness = 1.0F + tuning::separation_fraction;
/// Largest distance in m at which primitives of the thinnest cloth collide.
inline const auto thinnest_collision_distance_m =
    static_cast<float>(tuning::fold_speed_m_per_s / tuning::touching_regions_per_s);
/// Smallest ratio of the distance along the normal to the shortest distance for which the normal is certain.
inline constexpr float min_resolved_fraction = 0.9F;

/// Magnitudes, in m, of the numbers from which single precision computes the distance of a pair.
struct PairExtent {
  float from_origin = 0.0F;  ///< distance of the furthest corner
  float across = 0.0F;       ///< largest distance of two corners
  float moved = 0.0F;        ///< largest motion of a corner while regions last
  float displaced = 0.0F;    ///< largest displacement of a vertex since the frame began
};

/// Returns the largest distance in m at which primitives collide.
inline float collision_distance_m(float thickness_m) {
  return std::max(collision_distance_per_thickness * thickness_m,
                  thinnest_collision_distance_m - tuning::decrease_per_thickness * thickness_m);
}

/// Largest relative error of one operation in single precision.
inline constexpr float unit_roundoff = 0x1p-24F;
/// Number of such errors of each of these magnitudes, see distance_error_m().
inline constexpr PairExtent error_weights = {4.0F, 16.0F, 26.0F, 4.0F};

/// Returns a bound in m on the excess of the computed distance of a pair along its normal over the true one, at both
/// ends of the regions' time. With u the unit roundoff, for each of the two corners that decide: a position is rounded
/// twice (2u of its distance from the origin); its height is a difference and a product of vectors (4u of the size of
/// the pair), and so is its limit (4u more); moves, limits and displacements are added, multiplied and rounded 13
/// times; and the frame's displacement twice. Each corner may be off by the tolerance.
inline float distance_error_m(const PairExtent& extent) {
  constexpr PairExtent weights = error_weights;
  return 2.0F * tolerance_m +
         unit_roundoff * (weights.from_origin * extent.from_origin + weights.across * extent.across +
                          weights.moved * extent.moved + weights.displaced * extent.displaced);
}

/// Returns the gap in m that planes leave between two primitives. A pair is resolved above rounding if its distance
/// exceeds the error once after rounding; so planes leave the error twice.
inline float planned_gap_m(float thickness_m, float error_m) {
  return std::max(min_gap_fraction * thickness_m, 2.0F * error_m);
}

}  // namespace taut::sim::bounded
