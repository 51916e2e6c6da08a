#pragma once

#include "app/figures/experiments/experiments.hpp"
#include "app/figures/pictures.hpp"

namespace taut::app {

/// One figure, of the paper or about it: which experiments it needs and how it is drawn. Its functions know
/// the results they fill and draw from.
struct Figure {
  std::string name;                ///< "fig2"
  std::string title;               ///< what it shows, for the report
  std::vector<std::string> needs;  ///< names of the experiments it is drawn from
  /// Draws the figure from the results of its experiments.
  std::function<Drawing(LazyOffscreenRenderer&)> draw;
  /// Its data as tables NAME.csv and NAME_shapes.csv. Empty if the figure shows no measurement.
  std::function<std::string()> csv = {}, shapes_csv = {};
  /// Reads these tables into the results, so that the figure can be drawn without its experiments.
  std::function<void(const std::filesystem::path& folder)> read = {};
  /// Measures times that it shows. It is called when all experiments are done: they would take from what is
  /// measured.
  std::function<void(const ProgressCallback&)> measure = {};

  bool does_need(const std::string& experiment) const;
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

/// Reads the table of a figure into the results. Throws InputError that names the file and the line.
void read_figure3(Results& results, const std::filesystem::path& folder);
void read_figure6(Results& results, const std::filesystem::path& folder);
void read_figure7(Results& results, const std::filesystem::path& folder);

/// All figures of the paper, in its order, drawn from and filling these results.
std::vector<Figure> all_figures(Results& results);
/// Their names, in the same order.
std::vector<std::string> figure_names();

}  // namespace taut::app
