#pragma once

#include "app/scene/scene.hpp"
#include "sim/simulation.hpp"

namespace taut::app {

/// Simulates the frames before 0 s in which the scene's bodies grow into the clothes (dressing.hpp), without
/// gravity and wind, and ends with the clock at 0 s. Throws PromiseBroken if a frame cannot be made without a
/// crossing, or if several in a row break the bound where the scene does not accept that; Diverged;
/// Interrupted.
void dress(const Scene& scene, sim::Simulation& simulation);

/// Puts the simulation into the state that start.checkpoint of its scene names. Returns the number of that
/// frame. Without start.checkpoint it dresses the scene's bodies and returns 0. Throws InputError, also for a
/// garment that is too small by its girths alone (require_wearable()), and as dress() does, and PromiseBroken
/// if the garment crosses a body then and the solver would keep them apart; the message says where the
/// garment is too small (app/bodies/fit.hpp).
int go_to_start(const Scene& scene, sim::Simulation& simulation);

/// Returns that frame, and goes nowhere. Throws InputError where the checkpoint cannot be read.
int start_frame(const Scene& scene);

}  // namespace taut::app
