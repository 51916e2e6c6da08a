#pragma once

#include <filesystem>

#include "app/figures/pictures.hpp"

namespace taut::app {

/// One figure, of the paper or about it: which experiments it needs and how it is drawn. Its functions know
/// the results they fill and draw from.
struct Figure {
  std::string name;   ///< "fig2"
  std::string title;  ///< what it shows, for the report
  /// Names of the experiments it is drawn from. Without any it is drawn last.
  std::vector<std::string> needs;
  /// Draws the figure from the results of its experiments.
  std::function<Drawing(LazyOffscreenRenderer&)> draw;
  /// Its data as tables NAME.csv and NAME_shapes.csv. Empty if the figure shows no measurement.
  std::function<std::string()> csv = {}, shapes_csv = {};
  /// Measures times that it shows. It is called when all experiments are done: they would take from what is
  /// measured.
  std::function<void(const ProgressCallback&)> measure = {};

  bool does_need(const std::string& experiment) const { return std::ranges::find(needs, experiment) != needs.end(); }
};

/// Each draws one figure from the results of its experiments, which must have been made. Throws
/// renderer::ContextError.
Drawing draw_figure1(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure2(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure3(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure4(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure5(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure6(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure7(const Results& results, LazyOffscreenRenderer& offscreen);

/// The data of a figure as table: the first line holds the names of the columns.
std::string figure3_csv(const Results& results);
std::string figure6_csv(const Results& results);
std::string figure7_csv(const Results& results);

/// All figures of the paper, in its order, drawn from and filling these results.
std::vector<Figure> all_figures(Results& results);
/// Their names, in the same order.
std::vector<std::string> figure_names();

/// Which figures are drawn and to where: the options of `taut figures`.
struct FiguresOptions {
  std::vector<std::string> only;  ///< names of figures; empty: all
  std::filesystem::path output = "figures";
  float scale = 1.0F;            ///< times as many pixels each way
  std::string backend = "auto";  ///< as in renderer::create_context
};

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
/// needs are done. Where all are asked for, all experiments are made.
DrawnFigures draw_figures(const FiguresOptions& options, std::vector<Figure> figures, std::vector<Job> experiments);

}  // namespace taut::app
