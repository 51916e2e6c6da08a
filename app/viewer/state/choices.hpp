#pragma once

#include <vector>

#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// The built-in scenes, those about contact last. Those that belong to a figure of the paper have its label.
/// A scene that cannot be read is left out.
std::vector<Choice> scene_choices();

/// The garments that come with the program.
std::vector<Choice> garment_choices();

}  // namespace taut::app
