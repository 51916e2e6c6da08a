#pragma once

#include <string>

namespace taut::app {

/// What numbers were measured on and with.
struct Machine {
  std::string processor;
  unsigned threads = 0;
  std::string system;
  double load = 0.0;  ///< processes that wanted a processor, mean of the last minute
  std::string compiler;
  std::string program;
  std::string gl_renderer;
};

Machine this_machine(const std::string& gl_renderer);

}  // namespace taut::app
