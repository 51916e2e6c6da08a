#pragma once

#include <string>

namespace taut::app {

/// The machine and the program that numbers were measured with.
struct Machine {
  std::string processor;
  unsigned threads = 0;  ///< hardware threads
  std::string system;    ///< operating system
  double load = 0.0;     ///< processes that wanted a processor, averaged over the last minute
  std::string compiler;  ///< name and version
  std::string program;   ///< name and version
  std::string gl_renderer;
};

/// Reads the description of this machine.
Machine this_machine(const std::string& gl_renderer);

}  // namespace taut::app
