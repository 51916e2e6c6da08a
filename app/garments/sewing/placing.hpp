#pragma once

#include "app/garments/dressing/dressing.hpp"
#include "app/garments/sewing/cutting.hpp"

namespace taut::app {

/// Moves pieces that cross the body, each other or another layer outwards from this axis, or sideways. Then moves all
/// pieces inwards to the body as far as they keep clear, so that threads have less to draw. Without a body, pieces move
/// only apart, from this point. Returns how many crossed.
std::size_t part_and_draw_in(const sim::Surface& body, const sim::Vec3& axis_m, CutPieces& pieces);

/// Moves the pieces of a pattern to the dressed body of the scene. The pattern places them about a body of similar
/// size, with its feet or its chest at the origin. All pieces move up or down together, so that shoulder seams lie
/// above its shoulders, or the upper border where the body is as wide. Sleeves are turned to where arms begin. A
/// pattern that names a joint lies about that. Without a body, pieces stay where the pattern places them. Requires
/// loaded bodies (load_bodies()). Returns a report for people. Throws InputError if no body is dressed, or if its
/// measures or the joint are unknown.
std::vector<std::string> bring_to_body(const SewingPattern& pattern, const LoadedBodies& bodies, CutPieces& pieces);

/// Lets the body, if there is one, begin thin, with its arms nearly level and its legs in the legs of trousers. Moves
/// pieces outwards that cross the body or each other. Requires bring_to_body(). Returns a report for people.
std::vector<std::string> place_pieces(CutPieces& pieces, const Scene& scene, LoadedBodies& bodies);

// Steps of bring_to_body(). compute_shift() returns how far all pieces move, and marks the shoulder seams, which are
// closed first.
sim::Vec3 compute_shift(const SewingPattern& pattern, const Wearer& wearer, CutPieces& pieces,
                        std::vector<std::string>& said);
void turn_sleeves(const SewingPattern& pattern, const sim::Vec3& shift, const Wearer& wearer, CutPieces& pieces);

/// Returns the turned bones of arms and legs for the start of the body's growth.
std::vector<TurnedBone> turned_limbs(const Wearer& wearer, const CutPieces& pieces);

/// Returns a time at which the dressed body is thin, in s; 0 without a body.
double thin_time_s(const LoadedBodies& bodies);

}  // namespace taut::app
