#pragma once

#include "sim/garment.hpp"
#include "sim/pins.hpp"
#include "sim/solvers/bounded/settings.hpp"
#include "sim/state.hpp"

namespace taut::sim {

/// Predicate of allowed positions, in m.
using AllowPosition = std::function<bool(Index vertex, const Vec3& position_m)>;

/// Moves the cloth to a near shape within the bound, and keeps its velocity. In that shape no structural or shear
/// spring exceeds the bound, and no triangle if the settings bound the surface. Does nothing if the bound is kept
/// already. Pinned vertices stay; if pins are too far apart, the bound cannot be kept everywhere.
void move_within_bound(const Garment& garment, const Pins& pins, const BoundedSettings& settings, State& state);

/// Returns whether no structural or shear spring exceeds the bound, and no triangle if the settings bound the surface.
/// If all excesses are below a micrometre, it first shortens them in double precision. Single precision cannot resolve
/// a micrometre on cloth that moves by centimetres, and an edge of 1e-8 m is shorter than that. Vertices at positions
/// that `allow`, if given, rejects return to their old positions. `positions` are in metres, one per vertex, and are
/// changed.
[[nodiscard]] bool keeps_bound_in_double(const Garment& garment, const Pins& pins, const BoundedSettings& settings,
                                         std::span<Vec3> positions, const AllowPosition& allow = {});

/// Returns the largest excess length in m of a structural or shear spring, or of a triangle if the settings bound the
/// surface; 0 if none exceeds the bound.
double max_excess_m(const Garment& garment, const BoundedSettings& settings, std::span<const Vec3> positions);

/// Does one sweep, in double precision, over all springs and triangles that exceed the bound. Other vertices stay.
void shorten_once(const Garment& garment, const Pins& pins, const BoundedSettings& settings, std::span<Vec3> positions);

}  // namespace taut::sim
