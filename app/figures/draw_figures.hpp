#pragma once

#include "app/figures/figure_options.hpp"
#include "app/figures/figures.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

/// A figure that was drawn.
struct DrawnFigure {
  std::string name;
  std::string title;
  renderer::Image picture;
  bool has_table = false;  ///< NAME.csv
};

/// All figures of a run, by name.
struct DrawnFigures {
  std::vector<DrawnFigure> figures;
  std::string gl_renderer;  ///< the name OpenGL gives its renderer; empty: it was not needed
};

/// Draws those figures that are asked for and writes each, with its tables, as soon as the experiments it
/// needs are done; and a contact sheet of several. Where all are asked for, all experiments are made.
DrawnFigures draw_figures(const FiguresOptions& options, std::vector<Figure> figures, std::vector<Job> experiments);

/// How pictures lie on a contact sheet.
struct SheetLayout {
  int columns = 3;
  int cell_px = 800;  ///< width of a picture
  float title_px = 30.0F;
};

/// All figures, small, on one picture, each in the column that is shortest so far. `scale` multiplies its
/// pixels each way.
renderer::Image contact_sheet(std::span<const DrawnFigure> figures, float scale = 1.0F, const SheetLayout& layout = {});

}  // namespace taut::app
