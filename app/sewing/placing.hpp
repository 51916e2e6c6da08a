#pragma once

#include "app/bodies/dressing.hpp"
#include "app/sewing/cutting.hpp"

namespace taut::app {

/// Moves pieces that cross the body at that time, each other, or another layer outwards from the axis of the
/// body or sideways; then all inwards as far as they keep clear, so that threads have less to draw. Returns
/// how many crossed.
std::size_t part_and_draw_in(const sim::Body& body, double time_s, const sim::Vec3& axis_m, CutPieces& pieces);

/// Brings the pieces of a pattern to the body of the scene that is dressed. Their pattern places them about a
/// body that is about as large, with its feet or its chest at the origin: all go up or down together, so that
/// shoulder seams lie above its shoulders, or the upper border where it is as wide; and sleeves are turned to
/// where arms begin. Requires that the bodies are loaded (load_bodies()). Returns what was done, for people.
/// Throws InputError if nobody is dressed or cannot be told up from down.
std::vector<std::string> bring_to_body(const SewingPattern& pattern, const Scene& scene, CutPieces& pieces);

/// Lets the body begin thin, its arms nearly level and its legs in those of trousers, and moves pieces
/// outwards that cross it or each other. Requires bring_to_body(). Returns what was done, for people.
std::vector<std::string> place_pieces(CutPieces& pieces, Scene& scene);

// Of bring_to_body(): moves all up or down and returns how far; marks shoulder seams, which are closed first.
sim::Vec3 move_to_height(const SewingPattern& pattern, const Wearer& wearer, CutPieces& pieces,
                         std::vector<std::string>& said);
void turn_sleeves(const SewingPattern& pattern, const sim::Vec3& shift, const Wearer& wearer, CutPieces& pieces);

/// The bones of arms and legs where the body begins.
std::vector<TurnedBone> turned_limbs(const Wearer& wearer, const CutPieces& pieces);

/// How many frames after 0 s a body takes to its own shape, where parts of it that are near each other had
/// stayed back to leave room for cloth.
inline constexpr int frames_to_own_shape = 30;

/// A time at which the body that is dressed is thin, in s.
double thin_time_s(const Scene& scene);

}  // namespace taut::app
