#pragma once

#include <vector>

#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// Motions for the first body of the scene that has joints: those that come with the program and fit
/// it, then its own animations. None if there is no such body or it cannot be read. `known` is returned if it
/// is of that body's file.
MotionChoices motion_choices(const DrawnScene& scene, const MotionChoices& known);

/// Returns whether a body moves as the choice says.
bool is_chosen(const Choice& motion, const BodySource& source);

/// Returns the scene with its body moved as the choice says, over and over unless its end is too far from its
/// begin, and begun anew. `remarks` gets what load_bodies() says. Throws InputError.
DrawnScene with_motion(const DrawnScene& scene, std::size_t body, const Choice& motion,
                       std::vector<std::string>& remarks);

}  // namespace taut::app
