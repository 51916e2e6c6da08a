#include "app/figures/figures.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "app/commands/options.hpp"
#include "app/files.hpp"
#include "app/interruption.hpp"
#include "app/version.hpp"

namespace taut::app {

std::vector<Figure> all_figures() {
  return {{"fig2", draw_figure2}, {"fig4", draw_figure4}, {"fig5", draw_figure5}};
}

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (const Figure& figure : all_figures()) {
    names.push_back(figure.name);
  }
  return names;
}

int run(const FiguresOptions& options) {
  prepare_folder_of(options.output / "fig.png");
  Studio studio(options.backend);
  const std::vector<renderer::PngText> texts = {{"Software", "taut " + program_version()}};
  // Figures are written once and kept: better packed than frames.
  constexpr renderer::PngEffort effort = {.deflate_level = 9, .filter = -1};
  for (const Figure& figure : all_figures()) {
    const bool is_wanted = options.only.empty() || std::find(options.only.begin(), options.only.end(),
                                                             figure.name) != options.only.end();
    if (!is_wanted) {
      continue;
    }
    throw_if_interrupted();
    const std::filesystem::path path = options.output / (figure.name + ".png");
    renderer::write_png(path, figure.draw(studio), texts, effort);
    fmt::print("wrote {}\n", path.string());
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace taut::app
