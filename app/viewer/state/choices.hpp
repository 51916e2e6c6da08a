#pragma once

#include <string>
#include <vector>

#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// The built-in scenes, those about contact last. Those that belong to a figure of the paper have its label.
/// A scene that cannot be read is left out.
std::vector<Choice> scene_choices();

/// The files with this ending in a folder of those that come with the program, sorted by name.
std::vector<Choice> files_in(const std::string& folder, const std::string& ending);

/// The garments that come with the program.
inline std::vector<Choice> garment_choices() {
  return files_in("garments", ".obj");
}

}  // namespace taut::app
