#pragma once

#include <string>

namespace taut::app {

/// Explains an item of the panel, with its unit. Empty for a name that the panel does not have.
std::string hint_for(const std::string& name);

}  // namespace taut::app
