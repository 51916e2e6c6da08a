#include "app/scene/scene_file.hpp"

#include "app/base/errors.hpp"

namespace taut::app {

Override parse_override(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError("--set " + text + ": expected KEY=VALUE, such as --set solver.substeps=40");
  }
  return {text.substr(0, equals), text.substr(equals + 1), "--set " + text};
}

}  // namespace taut::app
