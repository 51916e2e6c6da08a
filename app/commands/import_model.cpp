#include "app/commands/options.hpp"

namespace taut::app {

int run(const ImportModelOptions& options) {
  return serve_import(options.model, options.limits, static_cast<ReadParts>(options.parts));
}

}  // namespace taut::app
