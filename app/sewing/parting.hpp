#pragma once

#include "app/sewing/cutting.hpp"
#include "sim/contact/bodies.hpp"

namespace taut::app {

/// Moves pieces that cross the body at that time, each other, or another layer outwards from the axis of the
/// body or sideways; then all inwards as far as they keep clear, so that threads have less to draw. Returns
/// how many crossed.
std::size_t part_and_draw_in(const sim::Body& body, double time_s, const sim::Vec3& axis_m, CutPieces& pieces);

}  // namespace taut::app
