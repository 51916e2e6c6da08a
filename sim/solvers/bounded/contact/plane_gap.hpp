#pragma once

#include "prelude.hpp"

namespace taut::sim::bounded {

// How far two things stay apart that planes keep apart, and all that this has to be more than.

/// The planes of a pair leave this part of its thickness between its two things.
inline constexpr float least_part = 0.1F;
/// Kinematic things stay this part of the thickness near to their chords while regions last: of what planes
/// leave, two of them take less than a half.
inline constexpr float off_chord_part = 0.02F;
/// Vertices further out than this, in m, are not within a half-space.
inline constexpr float tolerance_m = 2e-8F;

/// How large the numbers are, in m, from which single precision gets the distance of a pair.
struct PairExtent {
  float from_origin = 0.0F;  ///< of the furthest corner
  float across = 0.0F;       ///< from one corner to another
  float moved = 0.0F;        ///< how far a corner may go while regions last
  float displaced = 0.0F;    ///< how far a vertex has gone since the frame began
};

/// Returns a bound on how far the true distance of a pair along its normal is below the one that regions take
/// it to have, in m, at both ends of their time. With u = 2^-24, for each of the two corners that decide: a
/// position is rounded twice (2u of its distance from the origin); its height is a difference and a product
/// of vectors (4u of the size of the pair), and so is its limit (4u more); moves, limits and displacements
/// are added, multiplied and rounded 13 times; and the frame's displacement twice. Each may be out by the
/// tolerance.
inline float distance_error_m(const PairExtent& extent) {
  constexpr float u = 0x1p-24F;
  return 2.0F * tolerance_m +
         u * (4.0F * extent.from_origin + 16.0F * extent.across + 26.0F * extent.moved + 4.0F * extent.displaced);
}

/// Returns the distance that planes leave between two things which have so much, in m. A pair that has the
/// error once after rounding is told apart; so planes leave it twice.
inline float least_gap_m(float thickness_m, float error_m) {
  return std::max(least_part * thickness_m, 2.0F * error_m);
}

}  // namespace taut::sim::bounded
