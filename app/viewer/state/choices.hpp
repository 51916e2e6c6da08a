#pragma once

#include <vector>

#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// The built-in scenes; those that are figures of the paper are labelled. One that cannot be read is left
/// out.
std::vector<Choice> scene_choices();

/// The garments that come with the program.
std::vector<Choice> garment_choices();

}  // namespace taut::app
