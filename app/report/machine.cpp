#include "app/report/machine.hpp"

#include <sys/utsname.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "app/base/version.hpp"

namespace taut::app {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

std::string system_name() {
  utsname name = {};
  if (::uname(&name) != 0) {
    return "unknown";
  }
  // Not the node: reports are passed on.
  return std::string(name.sysname) + ' ' + name.release + ' ' + name.machine;
}

}  // namespace

Machine this_machine(const std::string& gl_renderer) {
  Machine machine;
  machine.processor = processor_name();
  machine.threads = std::thread::hardware_concurrency();
  machine.system = system_name();
  if (::getloadavg(&machine.load, 1) != 1) {
    machine.load = 0.0;
  }
  machine.compiler = compiler_version();
  machine.program = "taut " + program_version();
  machine.gl_renderer = gl_renderer;
  return machine;
}

}  // namespace taut::app
