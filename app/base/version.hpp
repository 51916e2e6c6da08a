#pragma once

#include "prelude.hpp"

namespace taut::app {

/// The version of the program, such as "0.1.0".
std::string program_version();
/// Name and version of the compiler that built the program.
std::string compiler_version();

}  // namespace taut::app
