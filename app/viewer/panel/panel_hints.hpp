#pragma once

#include <string>

namespace taut::app {

/// What a named thing of the panel does and in which unit; empty for a name that the panel does not have.
std::string hint_for(const std::string& name);

}  // namespace taut::app
