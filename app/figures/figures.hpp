#pragma once

#include "app/figures/experiments/experiments.hpp"
#include "app/figures/pictures.hpp"

namespace taut::app {

/// One figure, of the paper or about it: which experiments it needs and how it is drawn.
struct Figure {
  std::string name;               ///< "fig2"
  std::string title;              ///< what it shows, for the report
  std::vector<Experiment> needs;  ///< experiments it is drawn from
  /// Draws the figure from the results of its experiments.
  Drawing (*draw)(const Results&, LazyOffscreenRenderer&);
  /// Its data as tables NAME.csv and NAME_shapes.csv. Null if the figure shows no measurement.
  std::string (*csv)(const Results&) = nullptr;
  std::string (*shapes_csv)(const Results&) = nullptr;
  /// Reads these tables into the results, so that the figure can be drawn without its experiments.
  void (*read)(const std::filesystem::path& folder, Results&) = nullptr;
  /// Measures times that it shows. It is called when all experiments are done: they would take from what is
  /// measured.
  void (*measure)(const ProgressCallback&, Results&) = nullptr;
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
Drawing draw_figure8(const Results& results, LazyOffscreenRenderer& offscreen);

/// The data of a figure as table: the first line holds the names of the columns.
std::string figure3_csv(const Results& results);
std::string figure6_csv(const Results& results);
std::string figure7_csv(const Results& results);
std::string figure8_csv(const Results& results);

/// Reads the table of a figure into the results. Throws InputError that names the file and the line.
void read_figure3(const std::filesystem::path& folder, Results& results);
void read_figure6(const std::filesystem::path& folder, Results& results);
void read_figure7(const std::filesystem::path& folder, Results& results);
void read_figure8(const std::filesystem::path& folder, Results& results);

/// All figures, in the order of the paper.
const std::vector<Figure>& all_figures();
/// Their names, in the same order.
std::vector<std::string> figure_names();

}  // namespace taut::app
