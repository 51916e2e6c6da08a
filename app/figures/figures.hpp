#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/studio.hpp"
#include "renderer/image.hpp"

namespace taut::app {

/// A figure of the paper.
struct Figure {
  std::string name;  ///< "fig2"
  renderer::Image (*draw)(Studio& studio);
};

renderer::Image draw_figure2(Studio& studio);
renderer::Image draw_figure4(Studio& studio);
renderer::Image draw_figure5(Studio& studio);

/// In the order of the paper.
std::vector<Figure> all_figures();
std::vector<std::string> figure_names();

}  // namespace taut::app
