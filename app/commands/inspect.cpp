#include <fmt/core.h>

#include "app/commands/options.hpp"
#include "app/garment/inspection.hpp"
#include "app/output/run_report.hpp"

namespace taut::app {

int run(const InspectOptions& options) {
  Scene scene;
  scene.garment.file = options.garment;
  apply_overrides(options.overrides, scene);
  const Inspection inspection = inspect_garment(scene);
  fmt::print("{}", options.json ? inspection_json(inspection) : describe(inspection));
  return 0;
}

}  // namespace taut::app
