#pragma once

#include <filesystem>

#include "app/figures/pictures.hpp"

namespace taut::app {

/// A figure of the paper or about it, with its experiments and its drawing. Its functions refer to the results that
/// they fill and draw from.
struct Figure {
  std::string name;   ///< "fig2"
  std::string title;  ///< title for the report
  /// Names of the experiments that it is drawn from; empty: it is drawn last.
  std::vector<std::string> needs;
  /// Draws the figure from the results of its experiments.
  std::function<Drawing(LazyOffscreenRenderer&)> draw;
  /// Make the tables NAME.csv and NAME_shapes.csv. Empty if the figure shows no measurement.
  std::function<std::string()> csv = {}, shapes_csv = {};
  /// Measures the times that the figure shows. Called last, because experiments would slow the measured code down.
  std::function<void(const ProgressCallback&)> measure = {};

  bool does_need(const std::string& experiment) const { return std::ranges::find(needs, experiment) != needs.end(); }
};

/// Draw a figure from the results of its experiments, which must be done. Throw renderer::ContextError.
Drawing draw_figure1(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure2(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure3(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure4(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure5(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure6(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure7(const Results& results, LazyOffscreenRenderer& offscreen);

/// Return the data of a figure as a table. The first line has the names of the columns.
std::string figure3_csv(const Results& results);
std::string figure6_csv(const Results& results);
std::string figure7_csv(const Results& results);

/// Returns all figures of the paper in its order. They fill `results` and draw from them.
std::vector<Figure> all_figures(Results& results);
/// Returns the names of all figures, in the same order.
std::vector<std::string> figure_names();

/// Options of `taut figures`.
struct FiguresOptions {
  std::vector<std::string> selected_names;  ///< names of figures; empty: all
  std::filesystem::path output = "figures";
  float scale = 1.0F;            ///< factor for the width and height of pictures
  std::string backend = "auto";  ///< see renderer::create_context
};

/// A figure that was drawn.
struct DrawnFigure {
  std::string name;
  std::string title;
  renderer::Image picture;
  bool has_table = false;  ///< NAME.csv exists
};

/// All figures of a run, by name.
struct DrawnFigures {
  std::vector<DrawnFigure> figures;
  std::string gl_renderer;  ///< OpenGL's name of its renderer; empty: OpenGL was not needed
};

/// Draws the requested figures. Each is written with its tables as soon as its experiments are done. If all figures are
/// requested, all experiments are made.
DrawnFigures draw_figures(const FiguresOptions& options, std::vector<Figure> figures, std::vector<Job> experiments);

}  // namespace taut::app
