#pragma once

#include "sim/garment.hpp"
#include "sim/pins.hpp"
#include "sim/solvers/bounded/settings.hpp"
#include "sim/state.hpp"

namespace taut::sim {

/// Returns whether a vertex may be at a position, in m.
using AllowPosition = std::function<bool(Index vertex, const Vec3& position_m)>;

/// Moves the cloth, keeping its velocity, to a near shape in which no structural or shear spring, and no
/// triangle if the settings hold the surface, exceeds their bound. Does nothing if the shape keeps the bound
/// already. Pinned vertices stay; where pins are too far apart the bound cannot be kept everywhere.
void move_within_bound(const Garment& garment, const Pins& pins, const BoundedSettings& settings, State& state);

/// Returns whether no structural or shear spring, and no triangle if the settings hold the surface, exceeds
/// the bound. First it shortens, in double precision, those that exceed it if none does by a micrometre or
/// more. Single precision cannot resolve a micrometre on cloth that moves by centimetres, and an edge of 1e-8
/// m is shorter than that. A vertex that is moved to where `allow`, if there is one, does not let it be stays
/// where it was.
/// `positions` are in metres, one per vertex, and are changed.
[[nodiscard]] bool keeps_bound_in_double(const Garment& garment, const Pins& pins, const BoundedSettings& settings,
                                         std::span<Vec3> positions, const AllowPosition& allow = {});

/// Returns by how much, in m, the structural or shear spring, or the triangle if the settings hold the
/// surface, that exceeds the bound the most is too long; 0 if none is.
double largest_excess_m(const Garment& garment, const BoundedSettings& settings, std::span<const Vec3> positions);

/// Does one sweep, in double precision, over all that exceeds the bound. Everything else stays where it is.
void shorten_once(const Garment& garment, const Pins& pins, const BoundedSettings& settings, std::span<Vec3> positions);

}  // namespace taut::sim
