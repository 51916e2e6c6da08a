#pragma once

#include <string>

namespace taut::app {

/// What the item of the panel does, and its unit. Empty for a name that the panel does not have.
std::string hint_for(const std::string& name);

}  // namespace taut::app
