#pragma once

#include <span>

#include "sim/garment.hpp"
#include "sim/pins.hpp"
#include "sim/solvers/bounded/settings.hpp"
#include "sim/state.hpp"

namespace taut::sim {

/// Moves the cloth, with its velocity, to the nearest shape found in which no structural or shear spring is
/// longer than `bounded` allows by these settings; not at all where the shape keeps the bound already. Pinned
/// vertices stay, so that where pins hold the cloth too far apart the bound cannot be kept everywhere.
void move_within_bound(const Garment& garment, const Pins& pins, const BoundedSettings& settings,
                       State& state);

/// Whether no structural or shear spring is longer than the bound allows, once those that are by less than a
/// micrometre have been shortened, in double precision. Of edges of 1e-8 m that is several times their
/// length, and less than single precision can tell of cloth that moved by some centimetres. Positions in
/// metres, by vertex.
bool keeps_bound_in_double(const Garment& garment, const Pins& pins, double max_stretch,
                           std::span<Vec3> positions);

}  // namespace taut::sim
