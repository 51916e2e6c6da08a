#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "app/drawing/drawing.hpp"
#include "app/sweeps/sweep.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

/// A number that the result of every run has.
struct SweepMeasure {
  const char* name;   ///< in results and tables
  const char* label;  ///< in plots
  double factor = 1.0;
  const char* suffix = "";
};

/// All that can be plotted.
std::span<const SweepMeasure> sweep_measures();

/// The results of a sweep as a table (CSV): a row for each run, those without a result too, and a column for
/// each axis and each measure.
std::string sweep_table(const Sweep& sweep);

/// The most pictures on a contact sheet.
inline constexpr std::size_t most_on_sheet = 120;

/// The pictures of the runs, small, under the values that differ; of many, some at equal distances. One
/// column for each value of the last axis that has several. Returns an image of no size if there are none.
renderer::Image sweep_sheet(const Sweep& sweep);

/// The axes of a plot.
struct SweepPlot {
  std::vector<std::string> measures;  ///< a row of plots each
  std::string x;                      ///< the key across
  std::string curves;                 ///< the key with a curve for each value; empty: one curve
};

/// Plots measures over two axes, with a column for every combination of the other axes' values; where those
/// are more than four, one column with the mean and bars from the smallest to the largest. Rings mark runs
/// that broke a promise. Values that are not numbers stand side by side in the study's order. Throws
/// UsageError for a name or an axis that cannot be plotted.
Drawing draw_sweep(const Sweep& sweep, const SweepPlot& plot);

}  // namespace taut::app
