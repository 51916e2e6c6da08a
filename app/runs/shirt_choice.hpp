#pragma once

#include "sim/simulation.hpp"

namespace taut::app {

/// Times 36 frames of a built-in T-shirt in the wind of 10 m/s for which the sliders of the window and the page are
/// made. Returns the number of triangles of the largest one that this machine simulates in real time, in 20 m/s nearly.
/// `timed`: the T-shirt at its start. `advance_frame`: simulates its next frame.
int find_shirt_in_real_time(const sim::Simulation& timed, const std::function<void()>& advance_frame);

}  // namespace taut::app
