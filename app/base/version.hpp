#pragma once

#include <string>

namespace taut::app {

/// "0.1.0".
std::string program_version();
/// What the program was compiled with.
std::string compiler_version();

}  // namespace taut::app
