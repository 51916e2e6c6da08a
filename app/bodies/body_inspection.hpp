#pragma once

#include "app/bodies/body_girths.hpp"
#include "app/bodies/motion_opening.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

/// Reads a body and goes through all of its motion. Returns for programs, with units in the names of numbers:
/// its size, girths as it was stored, joints that vertices follow, the motion or the clip that is played, the
/// frames in which it crosses itself, of some spread over the motion, and what was guessed and repaired.
/// Throws InputError as load_bodies() does.
Json inspect_body(const BodySource& source);

/// The same as text for people.
std::string describe_body(const Json& body);

}  // namespace taut::app
