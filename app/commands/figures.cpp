#include "app/commands/options.hpp"

namespace taut::app {

int run(const FiguresOptions& options) {
  Results results;
  draw_figures(options, all_figures(results), experiments(results));
  return 0;
}

}  // namespace taut::app
