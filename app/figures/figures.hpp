#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/drawing/drawing.hpp"
#include "app/figures/experiments/experiments.hpp"
#include "app/figures/lazy_offscreen_renderer.hpp"

namespace taut::app {

/// A figure of the paper, or of what it argues.
struct Figure {
  std::string name;   ///< "fig2"
  std::string title;  ///< what it shows, for the report
  std::vector<Experiment> needs;
  Drawing (*draw)(const Results&, LazyOffscreenRenderer&);
  /// What it is drawn from, as tables NAME.csv and NAME_shapes.csv; none where it is not measured.
  std::string (*csv)(const Results&) = nullptr;
  std::string (*shapes_csv)(const Results&) = nullptr;
  /// Takes it from those tables, so that the figure can be drawn without its experiments.
  void (*read)(const std::filesystem::path& folder, Results&) = nullptr;
  bool needs_frame_times = false;
};

Drawing draw_figure1(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure2(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure3(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure4(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure5(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure6(const Results& results, LazyOffscreenRenderer& offscreen);
Drawing draw_figure7(const Results& results, LazyOffscreenRenderer& offscreen);
std::string figure2_csv(const Results& results);
std::string figure3_csv(const Results& results);
std::string figure4_csv(const Results& results);
std::string figure5_csv(const Results& results);
std::string figure6_csv(const Results& results);
std::string figure7_csv(const Results& results);
std::string figure2_shapes_csv(const Results& results);
std::string figure4_shapes_csv(const Results& results);
std::string figure5_shapes_csv(const Results& results);

// Each throws InputError naming the file, and the line if it is there.
void read_figure2(const std::filesystem::path& folder, Results& results);
void read_figure3(const std::filesystem::path& folder, Results& results);
void read_figure4(const std::filesystem::path& folder, Results& results);
void read_figure5(const std::filesystem::path& folder, Results& results);
void read_figure6(const std::filesystem::path& folder, Results& results);
void read_figure7(const std::filesystem::path& folder, Results& results);

/// In the order of the paper.
const std::vector<Figure>& all_figures();
std::vector<std::string> figure_names();

}  // namespace taut::app
